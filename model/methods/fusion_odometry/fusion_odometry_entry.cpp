#include "messages/drives.h"
#include "messages/methods.h"
#include "model/method_registry/method_needs.h"
#include "model/methods/fusion_odometry/fusion_odometry_method.h"

namespace remount::methods {
namespace {

Message lack_for_fusion(const drive::Session& session, const method_registry::GivenSessions&) {
  if (!method_registry::has_scans(session)) return say::lacks_scans_for_odometry();
  return method_registry::has_ins(session) ? Message() : say::lacks_ins();
}

}  // namespace

constinit const method_registry::CalibrationMethod kFusionOdometryMethod{
    .id = "fusion-odometry",
    .title = say::method_title_fusion_odometry,
    .needs = say::needs_of_fusion_odometry,
    .lack = lack_for_fusion,
    .settings_section = "fusion",
    .from_pairs = true,
    .run = method_registry::solver(run_fusion_method)};

}  // namespace remount::methods
