#include "algorithms/calibration/mounting.h"

#include "algorithms/core/error.h"
#include "messages/drives.h"

namespace remount {
namespace {

constexpr std::array<std::string_view, 5> kFrameNames{"ins", "vehicle", "machine", "antenna", "lidar"};

Message reference_in_words(BodyFrame reference) {
  switch (reference) {
    case BodyFrame::Ins:
      return say::frame_ins();
    case BodyFrame::Vehicle:
      return say::frame_vehicle();
    case BodyFrame::Machine:
      return say::frame_machine();
    case BodyFrame::Antenna:
      return say::frame_antenna();
    case BodyFrame::Lidar:
      break;
  }
  return say::frame_lidar();
}

Message thing_in_words(const std::optional<BodyFrame>& sensor) {
  if (!sensor) return say::thing_sensor();
  switch (*sensor) {
    case BodyFrame::Ins:
      return say::thing_ins();
    case BodyFrame::Vehicle:
      return say::thing_vehicle();
    case BodyFrame::Machine:
      return say::thing_machine();
    case BodyFrame::Antenna:
      return say::thing_antenna();
    case BodyFrame::Lidar:
      break;
  }
  return say::thing_lidar();
}

void require_same(const MountingFrames& given, const MountingFrames& asked) {
  if (Message reason = mixed_frames(given, asked); !reason.empty())
    throw Error(ErrorCode::Contract, "mounting", std::move(reason));
}

}  // namespace

std::string_view to_string(BodyFrame frame) { return kFrameNames.at(static_cast<std::size_t>(frame)); }

std::optional<BodyFrame> frame_from_string(std::string_view text) {
  for (const BodyFrame frame : kFrames)
    if (to_string(frame) == text) return frame;
  return std::nullopt;
}

Message in_words(const MountingFrames& frames) {
  return say::placed_in(thing_in_words(frames.sensor), reference_in_words(frames.reference));
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

Vector6d difference(const Mounting& from, const Mounting& to) {
  require_same(to.frames(), from.frames());
  return difference(from.reference_from_sensor, to.reference_from_sensor);
}

}  // namespace remount
