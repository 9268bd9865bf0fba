#include "messages/drives.h"
#include "messages/methods.h"
#include "model/method_registry/method_needs.h"
#include "model/methods/trajectory/trajectory_method.h"

namespace remount::methods {
namespace {

Message lack_for_trajectory(const drive::Session& session, const method_registry::GivenSessions&) {
  if (!method_registry::has_lidar(session)) return say::lacks_lidar();
  if (!method_registry::has_ins(session) && session.gnss.size() < 2) return say::lacks_reference();
  return {};
}

Message limit_of_trajectory(const drive::Session& session) {
  return method_registry::has_ins(session) ? Message() : say::lever_arm_alone();
}

}  // namespace

constinit const method_registry::CalibrationMethod kTrajectoryMethod{
    .id = "trajectory",
    .title = say::method_title_trajectory,
    .needs = say::needs_of_trajectory,
    .lack = lack_for_trajectory,
    .limit = limit_of_trajectory,
    .settings_section = "trajectory",
    .run = method_registry::solver(run_trajectory_method)};

}  // namespace remount::methods
