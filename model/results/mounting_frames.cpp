#include "model/results/mounting_frames.h"

#include "messages/drives.h"

namespace remount {
namespace {

MountingFrames start_of_method(const CalibrationMethod& method, const GivenSessions& sessions) {
  return method.frames ? method.frames(sessions) : MountingFrames();
}

}  // namespace

std::string name_of(const MountingFrames& frames) {
  const std::string sensor = frames.sensor ? std::string(to_string(*frames.sensor)) : "sensor";
  return std::string(to_string(frames.reference)) + "_from_" + sensor;
}

Message frame_problem(const MountingFrames& nominal, const CalibrationMethod& method, const GivenSessions& sessions) {
  const MountingFrames start = start_of_method(method, sessions);
  if (nominal.reference == start.reference && (!nominal.sensor || nominal.sensor == start.sensor)) return {};
  return say::nominal_of_other_frame(in_words(nominal), std::string(method.id), in_words(start));
}

Message unused_declaration(const CalibrationMethod& method, const GivenSessions& sessions) {
  if (starts_from_ins(method)) return {};
  return say::nominal_of_session_unused(in_words(MountingFrames()), std::string(method.id),
                                        in_words(start_of_method(method, sessions)));
}

bool starts_from_ins(const CalibrationMethod& method) {
  return start_of_method(method, {}).reference == BodyFrame::Ins;
}

Message not_in_ins_frame(const MountingFrames& frames) {
  return mixed_frames(frames, {BodyFrame::Ins, BodyFrame::Lidar});
}

}  // namespace remount
