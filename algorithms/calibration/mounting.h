// Where a sensor sits, and between which frames that is: a place on the vehicle is another number in each of them.
#pragma once

#include <array>
#include <optional>
#include <string_view>

#include "algorithms/geometry/rigid_transform.h"
#include "algorithms/messages/message.h"

namespace remount::calibration {

enum class BodyFrame {
  Ins,      ///< of the GNSS/INS: forward, left, up, or as its log has them
  Vehicle,  ///< middle of the rear axle, on the ground
  Machine,  ///< on the slew axis
  Antenna,  ///< positions alone have no axes: those are the LiDAR's own, about the antenna
  Lidar,    ///< of the LiDAR, or of another sensor whose motion is given
};
inline constexpr std::array<BodyFrame, 5> kFrames{BodyFrame::Ins, BodyFrame::Vehicle, BodyFrame::Machine,
                                                  BodyFrame::Antenna, BodyFrame::Lidar};

/// "ins", "vehicle", "machine", "antenna", "lidar": as files have them.
std::string_view to_string(BodyFrame frame);
std::optional<BodyFrame> frame_from_string(std::string_view text);

struct MountingFrames {
  BodyFrame reference = BodyFrame::Ins;  ///< what coordinates are taken to
  std::optional<BodyFrame> sensor =
      BodyFrame::Lidar;  ///< what they are taken from; nothing: whatever a method calibrates

  friend bool operator==(const MountingFrames&, const MountingFrames&) = default;
};

/// What is placed where, for people: "the LiDAR in the INS frame".
Message in_words(const MountingFrames& frames);

/// Why a mounting in frames `given` cannot stand where one in frames `asked` is asked for, as the end of a sentence
/// about it; empty where it can.
Message mixed_frames(const MountingFrames& given, const MountingFrames& asked);

/// What a calibration finds. A vehicle with several LiDARs has one of each.
struct Mounting {
  BodyFrame reference = BodyFrame::Ins;
  /// Lidar, or Antenna, whose positions alone were calibrated: then there is no attitude.
  BodyFrame sensor = BodyFrame::Lidar;
  RigidTransform reference_from_sensor = RigidTransform::Identity();  ///< m

  MountingFrames frames() const { return {reference, sensor}; }
  bool is_of(const MountingFrames& asked) const { return frames() == asked; }
  /// reference_from_sensor, for whoever takes it to be between these frames. @throws Error (Contract) where it is not
  const RigidTransform& between(BodyFrame asked_reference, BodyFrame asked_sensor) const;
  const RigidTransform& ins_from_lidar() const { return between(BodyFrame::Ins, BodyFrame::Lidar); }
  /// sensor_from_reference.
  Mounting inverse() const { return {sensor, reference, reference_from_sensor.inverse()}; }
};

/// a_from_b * b_from_c. @throws Error (Contract) where the two do not meet in one frame
Mounting operator*(const Mounting& a_from_b, const Mounting& b_from_c);

/// perturb(from, delta) == to, as in rigid_transform.h. @throws Error (Contract) where they are of other frames
Vector6d mounting_difference(const Mounting& from, const Mounting& to);

}  // namespace remount::calibration
