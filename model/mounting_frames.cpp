#include "model/mounting_frames.h"

#include "model/method_needs.h"

namespace remount {
namespace {

std::string place_in_words(const std::string& reference) {
  if (reference == "ins") return "the INS frame";
  if (reference == "vehicle") return "the vehicle's frame (middle of the rear axle, on the ground)";
  if (reference == "machine") return "the machine's frame (on the slew axis)";
  if (reference == "antenna") return "the LiDAR's own axes about the antenna";
  return "the frame \"" + reference + "\"";
}

std::string thing_in_words(const std::string& calibrated) {
  if (calibrated == "lidar") return "the LiDAR";
  return calibrated.empty() ? "the sensor" : "the " + calibrated;
}

MountingFrames start_of_method(MethodChoice method, const std::vector<std::shared_ptr<const Session>>& sessions) {
  if (method == MethodChoice::Slew) return {"machine", "lidar"};
  if (method != MethodChoice::VehicleFrame) return {};
  const bool antenna = !sessions.empty() && has_antenna_only(*sessions.front());
  return {"vehicle", antenna ? "antenna" : "lidar"};
}

std::string placed_and_found(const MountingFrames& nominal, MethodChoice method, const MountingFrames& found) {
  return "places " + in_words(nominal) + ", and the method '" +
         std::string(kMethodIds.at(static_cast<std::size_t>(method))) + "' finds " + in_words(found);
}

}  // namespace

MountingFrames frames_of(const CalibrationResult& result) { return {result.reference_frame, result.calibrated}; }

std::string in_words(const MountingFrames& frames) {
  return thing_in_words(frames.calibrated) + " in " + place_in_words(frames.reference);
}

std::string frame_problem(const MountingFrames& nominal, MethodChoice method,
                          const std::vector<std::shared_ptr<const Session>>& sessions) {
  const MountingFrames start = start_of_method(method, sessions);
  if (nominal.reference == start.reference && (nominal.calibrated.empty() || nominal.calibrated == start.calibrated))
    return {};
  return placed_and_found(nominal, method, start) +
         ": the numbers of one are wrong in the other. Give a nominal mounting in that frame, or none.";
}

std::string unused_declaration(MethodChoice method, const std::vector<std::shared_ptr<const Session>>& sessions) {
  if (starts_from_ins(method)) return {};
  return "The nominal mounting of the session " + placed_and_found({}, method, start_of_method(method, sessions)) +
         ": it is not used. Give a nominal mounting in that frame, or none.";
}

bool starts_from_ins(MethodChoice method) { return start_of_method(method, {}).reference == "ins"; }

std::string not_in_ins_frame(const MountingFrames& frames) {
  const MountingFrames asked;
  if (frames.reference == asked.reference && frames.calibrated == asked.calibrated) return {};
  return "places " + in_words(frames) + ", and " + in_words(asked) +
         " is asked for: the numbers of one are wrong in the other.";
}

}  // namespace remount
