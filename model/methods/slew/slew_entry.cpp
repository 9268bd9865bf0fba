#include "messages/drives.h"
#include "messages/methods.h"
#include "model/method_registry/method_needs.h"
#include "model/methods/slew/slew_method.h"

namespace remount {
namespace {

Message lack_for_slew(const Session& session, const GivenSessions&) {
  return has_lidar(session) ? Message() : say::lacks_lidar();
}

MountingFrames frames_of_slew(const GivenSessions&) { return {BodyFrame::Machine, BodyFrame::Lidar}; }

}  // namespace

constinit const CalibrationMethod kSlewMethod{
    .id = "slew",
    .title = say::method_title_slew,
    .needs = say::needs_of_slew,
    .lack = lack_for_slew,
    .other_machine = {say::proviso_of_slew, say::session_unusable_but_excavator, say::served_with_rest_or_slew},
    .frames = frames_of_slew,
    .settings_section = "slew",
    .run = solver(run_slew)};

}  // namespace remount
