// A trajectory that can be asked for its pose at any time within the data.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "algorithms/geometry/rigid_transform.h"
#include "algorithms/trajectory/ins_sample.h"

namespace remount {

/// Stamped poses world_from_body with interpolation: attitude by slerp, position by a cubic through the neighbours (so
/// that a curve is not cut short), never outside the data and never across a gap.
class MotionTrack {
 public:
  MotionTrack() = default;
  /// @param world_from_body ascending stamps; samples that repeat or step back in time are left out
  /// @param max_gap_s longest distance between neighbours that is interpolated; 0: five times the median distance,
  ///        at least 0.25 s
  explicit MotionTrack(const std::vector<StampedPose>& world_from_body, double max_gap_s = 0.0);

  /// world_from_body at a time, or nothing outside the data or in a gap.
  std::optional<RigidTransform> at(std::int64_t stamp_ns) const;

  /// Velocity of the body at a time, in body axes: [m/s; rad/s] as a perturbation in body axes per second.
  std::optional<Vector6d> body_velocity(std::int64_t stamp_ns) const;

  const std::vector<StampedPose>& samples() const { return samples_; }
  bool empty() const { return samples_.empty(); }
  double max_gap_s() const { return max_gap_s_; }

 private:
  std::vector<StampedPose> samples_;
  double max_gap_s_ = 0.0;
};

}  // namespace remount
