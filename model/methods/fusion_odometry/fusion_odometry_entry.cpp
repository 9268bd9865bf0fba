#include "messages/drives.h"
#include "messages/methods.h"
#include "model/method_registry/method_needs.h"
#include "model/methods/fusion_odometry/fusion_odometry_method.h"

namespace remount {
namespace {

Message lack_for_fusion(const Session& session, const GivenSessions&) {
  if (!has_scans(session)) return say::lacks_scans_for_odometry();
  return has_ins(session) ? Message() : say::lacks_ins();
}

}  // namespace

constinit const CalibrationMethod kFusionOdometryMethod{.id = "fusion-odometry",
                                                        .title = say::method_title_fusion_odometry,
                                                        .needs = say::needs_of_fusion_odometry,
                                                        .lack = lack_for_fusion,
                                                        .settings_section = "fusion",
                                                        .from_pairs = true,
                                                        .run = solver(run_fusion_method)};

}  // namespace remount
