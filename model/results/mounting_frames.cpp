#include "model/results/mounting_frames.h"

#include "messages/drives.h"
#include "model/settings/method_needs.h"

namespace remount {
namespace {

Message frame_in_words(const std::string& reference) {
  if (reference == "ins") return say::frame_ins();
  if (reference == "vehicle") return say::frame_vehicle();
  if (reference == "machine") return say::frame_machine();
  if (reference == "antenna") return say::frame_antenna();
  return say::frame_named(reference);
}

Message thing_in_words(const std::string& calibrated) {
  if (calibrated == "lidar") return say::thing_lidar();
  if (calibrated == "antenna") return say::thing_antenna();
  return calibrated.empty() ? say::thing_sensor() : say::thing_named(calibrated);
}

MountingFrames start_of_method(MethodChoice method, const std::vector<std::shared_ptr<const Session>>& sessions) {
  if (method == MethodChoice::Slew) return {"machine", "lidar"};
  if (method != MethodChoice::VehicleFrame) return {};
  const bool antenna = !sessions.empty() && has_antenna_only(*sessions.front());
  return {"vehicle", antenna ? "antenna" : "lidar"};
}

std::string id_of(MethodChoice method) { return std::string(kMethodIds.at(static_cast<std::size_t>(method))); }

}  // namespace

MountingFrames frames_of(const CalibrationResult& result) { return {result.reference_frame, result.calibrated}; }

Message in_words(const MountingFrames& frames) {
  return say::placed_in(thing_in_words(frames.calibrated), frame_in_words(frames.reference));
}

Message frame_problem(const MountingFrames& nominal, MethodChoice method,
                      const std::vector<std::shared_ptr<const Session>>& sessions) {
  const MountingFrames start = start_of_method(method, sessions);
  if (nominal.reference == start.reference && (nominal.calibrated.empty() || nominal.calibrated == start.calibrated))
    return {};
  return say::nominal_of_other_frame(in_words(nominal), id_of(method), in_words(start));
}

Message unused_declaration(MethodChoice method, const std::vector<std::shared_ptr<const Session>>& sessions) {
  if (starts_from_ins(method)) return {};
  return say::nominal_of_session_unused(in_words({}), id_of(method), in_words(start_of_method(method, sessions)));
}

bool starts_from_ins(MethodChoice method) { return start_of_method(method, {}).reference == "ins"; }

Message not_in_ins_frame(const MountingFrames& frames) {
  const MountingFrames asked;
  if (frames.reference == asked.reference && frames.calibrated == asked.calibrated) return {};
  return say::mounting_not_in_ins_frame(in_words(frames), in_words(asked));
}

}  // namespace remount
