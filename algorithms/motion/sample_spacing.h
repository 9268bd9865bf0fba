// How far a motion may leave what is interpolated between its samples.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "algorithms/motion/ins_sample.h"

namespace remount::motion {

/// Samples that are no farther apart leave no room for motion between them.
inline constexpr double kSlowSamples_s = 0.15;

/// Samples of a quantity of three components, and how well each of them is told by its neighbours: twice as far apart
/// as they are, they miss it by so much, and as they are by less, in the proportion in which they miss it by less than
/// neighbours four times as far apart. Samples that come more than seven times a second leave no room for motion and
/// say nothing here: what they miss is their noise.
class SampleSpacing {
 public:
  SampleSpacing() = default;
  /// @param misses of each sample by its neighbours; NaN where there are too few
  /// @param proportion by which an interpolation misses less when samples are twice as close
  SampleSpacing(std::vector<std::int64_t> stamps_ns, std::vector<Eigen::Vector3d> misses, double proportion);

  /// Samples are so close that what they miss is their noise.
  bool empty() const { return squares_.empty(); }

  /// Covariance of what is interpolated at a time; zero at a sample, and where samples are close.
  Eigen::Matrix3d covariance(std::int64_t stamp_ns) const;
  /// Number of the last sample that is not behind a time; 0 where there is none.
  std::size_t knot_before(std::int64_t stamp_ns) const;

 private:
  std::vector<std::int64_t> stamps_ns_;
  std::vector<Eigen::Matrix3d> squares_;  // of the misses between this sample and the next
  double proportion_ = 1.0;
};

/// Of attitudes whose turns are interpolated by a cubic; components are turns about the body's axes.
SampleSpacing spacing_of_attitudes(const std::vector<StampedPose>& world_from_body);
/// Of positions that are interpolated by a cubic through the neighbours; components are along the axes of the world.
SampleSpacing spacing_of_positions(const std::vector<StampedPose>& world_from_body);

}  // namespace remount::motion
