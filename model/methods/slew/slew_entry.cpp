#include "messages/drives.h"
#include "messages/methods.h"
#include "model/method_registry/method_needs.h"
#include "model/methods/slew/slew_method.h"

namespace remount::methods {
namespace {

Message lack_for_slew(const drive::Session& session, const method_registry::GivenSessions&) {
  return method_registry::has_lidar(session) ? Message() : say::lacks_lidar();
}

calibration::MountingFrames frames_of_slew(const method_registry::GivenSessions&) {
  return {calibration::BodyFrame::Machine, calibration::BodyFrame::Lidar};
}

}  // namespace

constinit const method_registry::CalibrationMethod kSlewMethod{
    .id = "slew",
    .title = say::method_title_slew,
    .needs = say::needs_of_slew,
    .lack = lack_for_slew,
    .other_machine = {say::proviso_of_slew, say::session_unusable_but_excavator, say::served_with_rest_or_slew},
    .frames = frames_of_slew,
    .settings_section = "slew",
    .run = method_registry::solver(run_slew)};

}  // namespace remount::methods
