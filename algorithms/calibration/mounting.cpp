#include "algorithms/calibration/mounting.h"

#include "algorithms/core/error.h"
#include "algorithms/core/index.h"
#include "messages/drives.h"

namespace remount::calibration {
namespace {

constexpr std::array<std::string_view, 5> kFrameNames{"ins", "vehicle", "machine", "antenna", "lidar"};

// In the order of kFrames.
constexpr std::array<Message (*)(), 5> kReferences{say::frame_ins, say::frame_vehicle, say::frame_machine,
                                                   say::frame_antenna, say::frame_lidar};
constexpr std::array<Message (*)(), 5> kThings{say::thing_ins, say::thing_vehicle, say::thing_machine,
                                               say::thing_antenna, say::thing_lidar};

void require_same(const MountingFrames& given, const MountingFrames& asked) {
  if (Message reason = mixed_frames(given, asked); !reason.empty())
    throw Error(ErrorCode::Contract, "mounting", std::move(reason));
}

}  // namespace

std::string_view to_string(BodyFrame frame) { return kFrameNames.at(index_of(frame)); }

std::optional<BodyFrame> frame_from_string(std::string_view text) {
  for (const BodyFrame frame : kFrames)
    if (to_string(frame) == text) return frame;
  return std::nullopt;
}

Message in_words(const MountingFrames& frames) {
  const Message thing = frames.sensor ? kThings.at(index_of(*frames.sensor))() : say::thing_sensor();
  return say::placed_in(thing, kReferences.at(index_of(frames.reference))());
}

Message mixed_frames(const MountingFrames& given, const MountingFrames& asked) {
  if (given == asked) return {};
  return say::mounting_of_other_frames(in_words(given), in_words(asked));
}

const RigidTransform& Mounting::between(BodyFrame asked_reference, BodyFrame asked_sensor) const {
  require_same(frames(), {asked_reference, asked_sensor});
  return reference_from_sensor;
}

Mounting operator*(const Mounting& a_from_b, const Mounting& b_from_c) {
  require_same(b_from_c.frames(), {a_from_b.sensor, b_from_c.sensor});
  return {a_from_b.reference, b_from_c.sensor, a_from_b.reference_from_sensor * b_from_c.reference_from_sensor};
}

Vector6d mounting_difference(const Mounting& from, const Mounting& to) {
  require_same(to.frames(), from.frames());
  return difference(from.reference_from_sensor, to.reference_from_sensor);
}

}  // namespace remount::calibration
