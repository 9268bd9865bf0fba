#include "model/results/mounting_frames.h"

#include "algorithms/core/error.h"
#include "messages/drives.h"

namespace remount::results {
namespace {

calibration::MountingFrames start_of_method(const method_registry::CalibrationMethod& method,
                                            const method_registry::GivenSessions& sessions) {
  return method.frames ? method.frames(sessions) : calibration::MountingFrames();
}

}  // namespace

std::string name_of(const calibration::MountingFrames& frames) {
  const std::string sensor = frames.sensor ? std::string(to_string(*frames.sensor)) : "sensor";
  return std::string(to_string(frames.reference)) + "_from_" + sensor;
}

Message frame_problem(const calibration::MountingFrames& nominal, const method_registry::CalibrationMethod& method,
                      const method_registry::GivenSessions& sessions) {
  const calibration::MountingFrames start = start_of_method(method, sessions);
  if (nominal.reference == start.reference && (!nominal.sensor || nominal.sensor == start.sensor)) return {};
  return say::nominal_of_other_frame(calibration::in_words(nominal), std::string(method.id),
                                     calibration::in_words(start));
}

Message unused_declaration(const method_registry::CalibrationMethod& method,
                           const method_registry::GivenSessions& sessions) {
  if (starts_from_ins(method)) return {};
  return say::nominal_of_session_unused(calibration::in_words(calibration::MountingFrames()), std::string(method.id),
                                        calibration::in_words(start_of_method(method, sessions)));
}

bool starts_from_ins(const method_registry::CalibrationMethod& method) {
  return start_of_method(method, {}).reference == calibration::BodyFrame::Ins;
}

std::optional<RigidTransform> declared_nominal(const method_registry::GivenSessions& sessions,
                                               const method_registry::CalibrationMethod& method) {
  std::optional<RigidTransform> declared;
  if (!starts_from_ins(method)) return declared;
  for (const auto& session : sessions) {
    if (!session->nominal_ins_from_lidar) continue;
    if (declared && !declared->isApprox(*session->nominal_ins_from_lidar, 1e-9))
      throw Error(ErrorCode::Contract, session->name, say::nominal_of_sessions_differs());
    declared = session->nominal_ins_from_lidar;
  }
  return declared;
}

Message not_in_ins_frame(const calibration::MountingFrames& frames) {
  return calibration::mixed_frames(frames, {calibration::BodyFrame::Ins, calibration::BodyFrame::Lidar});
}

}  // namespace remount::results
