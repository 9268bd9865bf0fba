// A LiDAR scan as the readers deliver it.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

namespace remount::cloud {

/// A coordinate beyond it is that of no return; its square would not fit a float either.
inline constexpr float kFarthestReturn_m = 1e5f;

/// Points in the lidar frame. Optional columns are empty or as long as `points`.
/// Readers leave out what is no return or has no place in the scan's time, and count it in `dropped_points`.
struct PointCloud {
  std::vector<Eigen::Vector3f> points;   ///< metres, lidar frame
  std::vector<float> time_from_stamp_s;  ///< per-point time minus the scan's stamp
  std::vector<float> intensity;          ///< as recorded, no unit
  std::vector<std::uint16_t> ring;       ///< beam index, 0 is the lowest
  /// Points that the reader left out: not finite, at zero range, a coordinate beyond kFarthestReturn_m, or a time that
  /// is not finite or not of the scan.
  std::size_t dropped_points = 0;

  std::size_t size() const { return points.size(); }
};

}  // namespace remount::cloud
