#include "messages/drives.h"
#include "messages/methods.h"
#include "model/method_registry/method_needs.h"
#include "model/methods/trajectory/trajectory_method.h"

namespace remount {
namespace {

Message lack_for_trajectory(const Session& session, const GivenSessions&) {
  if (!has_lidar(session)) return say::lacks_lidar();
  if (!has_ins(session) && session.gnss.size() < 2) return say::lacks_reference();
  return {};
}

Message limit_of_trajectory(const Session& session) { return has_ins(session) ? Message() : say::lever_arm_alone(); }

}  // namespace

constinit const CalibrationMethod kTrajectoryMethod{.id = "trajectory",
                                                    .title = say::method_title_trajectory,
                                                    .needs = say::needs_of_trajectory,
                                                    .lack = lack_for_trajectory,
                                                    .limit = limit_of_trajectory,
                                                    .settings_section = "trajectory",
                                                    .run = solver(run_trajectory_method)};

}  // namespace remount
