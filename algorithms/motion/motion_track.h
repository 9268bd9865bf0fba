// A trajectory that can be asked for its pose at any time within the data.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "algorithms/geometry/rigid_transform.h"
#include "algorithms/motion/ins_sample.h"
#include "algorithms/motion/sample_spacing.h"

namespace remount::motion {

/// The motion of a body near one time: what a scan needs that is taken while the body moves. The track must outlive it.
class Passage {
 public:
  /// world_from_body at `time_s` from the stamp; nothing where the trajectory does not know.
  std::optional<RigidTransform> at(double time_s) const;
  RigidTransform pose() const { return *at(0.0); }

 private:
  friend class MotionTrack;
  RigidTransform fitted(double time_s, const RigidTransform& interpolated) const;
  using Parabola = Eigen::Matrix3d;  // columns: value, slope, half the curvature
  const class MotionTrack* track_ = nullptr;
  std::int64_t stamp_ns_ = 0;
  double middle_s_ = 0.0, half_window_s_ = 0.0;  ///< of the parabolas, from the stamp
  std::optional<Parabola> position_, turn_;      // nothing: interpolated
  Eigen::Matrix3d turned_from_ = Eigen::Matrix3d::Identity();
};

/// What is not known of a pose between two samples.
struct BetweenSamples {
  Matrix6d covariance = Matrix6d::Zero();  ///< of the pose in body axes, [nu; omega]
  std::size_t after = 0;  ///< number of the measured position before: poses between the same two err alike
};

/// Stamped poses world_from_body with interpolation: position by a cubic through the neighbours (so that a curve is not
/// cut short), attitude by slerp, and by a cubic of turns where samples are slow; never outside the data and never
/// across a gap.
///
/// Logs whose samples carry independent noise would shake the points of a scan with it: worse, the noise of the pose at
/// the scan's stamp would enter the motion of the INS and, through the compensation of the scan, the motion of the
/// LiDAR alike, where it passes for excitation. Such noise is told from motion by third differences, and then `around`
/// fits a parabola to as much on either side of a scan's middle as the scan takes, 0.1 to 0.25 s. Filtered logs, whose
/// samples differ by true motion, are left as they are.
class MotionTrack {
 public:
  MotionTrack() = default;
  /// @param world_from_body ascending stamps; samples that repeat or step back in time are left out
  /// @param max_gap_s longest distance between neighbours that is interpolated; 0: five times the median distance,
  ///        at least 0.25 s
  /// @param fix_stamps_ns of the samples whose positions were measured, ascending, where those of the others were
  ///        interpolated between them; empty: all were
  /// @param sweep_s how long the scans take whose motion will be asked for
  explicit MotionTrack(const std::vector<StampedPose>& world_from_body, double max_gap_s = 0.0,
                       const std::vector<std::int64_t>& fix_stamps_ns = {}, double sweep_s = 0.0);

  /// world_from_body at a time, interpolated; nothing outside the data or in a gap.
  std::optional<RigidTransform> at(std::int64_t stamp_ns) const;

  /// The motion around a time, with sample noise averaged out where the log has any; nothing outside the data or in a
  /// gap.
  /// @param middle_s from the stamp, of the time that will be asked for: what is left of the noise is least about it,
  /// and twice as much at the edges of what is fitted
  std::optional<Passage> around(std::int64_t stamp_ns, double middle_s = 0.0) const&;
  std::optional<Passage> around(std::int64_t stamp_ns, double middle_s = 0.0) const&& = delete;

  /// Whether the samples carry noise that `around` averages out, in their positions or attitudes.
  bool smooths() const { return position_.on || attitude_.on; }
  /// For how long the noise of the middle of `around(t)` stays much the same, s: of two middles that lie half of it
  /// apart half of the variance is common, of two that lie all of it apart nothing. 0 where the log is not smoothed.
  double averaged_s() const { return smooths() ? half_window_s_ : 0.0; }
  /// How much of the samples' white noise is left in the middle of `around(t)`: 1 where the log is not smoothed. Next
  /// to the ends of the data and to gaps up to three times as much is left.
  double position_noise_factor() const { return position_.noise_factor; }
  double attitude_noise_factor() const { return attitude_.noise_factor; }

  /// How far the pose at a time may be off because it lies between samples; nothing outside the data.
  std::optional<BetweenSamples> between_samples(std::int64_t stamp_ns) const;

  /// Velocity of the body at a time, in body axes: [m/s; rad/s] as a perturbation in body axes per second. The mean of
  /// half a second to either side, of turns of 0.2 s; of 40 ms near gaps and ends.
  std::optional<Vector6d> body_velocity(std::int64_t stamp_ns) const;

  const std::vector<StampedPose>& samples() const { return samples_; }
  bool empty() const { return samples_.empty(); }
  double max_gap_s() const { return max_gap_s_; }

 private:
  struct Smoothing {
    bool on = false;
    double noise_factor = 1.0;
  };
  /// Velocity as the slope of the motion from so much before to so much after; nothing where there is a gap.
  std::optional<Vector6d> slope(std::int64_t stamp_ns, std::int64_t back_ns, std::int64_t forth_ns) const;
  struct Window;
  struct Roughness;
  std::optional<Roughness> roughness(std::size_t sample) const;
  Window window(std::int64_t stamp_ns) const;
  void choose_smoothing();

  std::vector<StampedPose> samples_;
  SampleSpacing position_spacing_, attitude_spacing_;
  double max_gap_s_ = 0.0, half_window_s_ = 0.0;
  Smoothing position_, attitude_;
};

}  // namespace remount::motion
