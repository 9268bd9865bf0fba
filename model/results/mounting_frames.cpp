#include "model/results/mounting_frames.h"

#include "algorithms/core/index.h"
#include "messages/drives.h"
#include "model/settings/method_needs.h"

namespace remount {
namespace {

MountingFrames start_of_method(MethodChoice method, const std::vector<std::shared_ptr<const Session>>& sessions) {
  if (method == MethodChoice::Slew) return {BodyFrame::Machine, BodyFrame::Lidar};
  if (method != MethodChoice::VehicleFrame) return {};
  const bool antenna = !sessions.empty() && has_antenna_only(*sessions.front());
  return {BodyFrame::Vehicle, antenna ? BodyFrame::Antenna : BodyFrame::Lidar};
}

std::string id_of(MethodChoice method) { return std::string(kMethodIds.at(index_of(method))); }

}  // namespace

std::string name_of(const MountingFrames& frames) {
  const std::string sensor = frames.sensor ? std::string(to_string(*frames.sensor)) : "sensor";
  return std::string(to_string(frames.reference)) + "_from_" + sensor;
}

Message frame_problem(const MountingFrames& nominal, MethodChoice method,
                      const std::vector<std::shared_ptr<const Session>>& sessions) {
  const MountingFrames start = start_of_method(method, sessions);
  if (nominal.reference == start.reference && (!nominal.sensor || nominal.sensor == start.sensor)) return {};
  return say::nominal_of_other_frame(in_words(nominal), id_of(method), in_words(start));
}

Message unused_declaration(MethodChoice method, const std::vector<std::shared_ptr<const Session>>& sessions) {
  if (starts_from_ins(method)) return {};
  return say::nominal_of_session_unused(in_words(MountingFrames()), id_of(method),
                                        in_words(start_of_method(method, sessions)));
}

bool starts_from_ins(MethodChoice method) { return start_of_method(method, {}).reference == BodyFrame::Ins; }

Message not_in_ins_frame(const MountingFrames& frames) {
  return mixed_frames(frames, {BodyFrame::Ins, BodyFrame::Lidar});
}

}  // namespace remount
