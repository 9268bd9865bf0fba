// What a navigation system reports at one time.
#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <limits>

#include "algorithms/geometry/rigid_transform.h"

namespace remount::motion {

/// 1-sigma as the log states it; NaN where it does not. Attitude errors are about the INS axes x (roll), y (pitch), z
/// (yaw).
struct InsSigma {
  Eigen::Vector3d position_enu_m = Eigen::Vector3d::Constant(std::numeric_limits<double>::quiet_NaN());
  Eigen::Vector3d attitude_rad = Eigen::Vector3d::Constant(std::numeric_limits<double>::quiet_NaN());
};

enum class InsQuality { Unknown, Good, Degraded, Invalid };

/// One INS solution. Attitude is relative to true north and the local level: enu_from_ins with INS axes
/// x forward, y left, z up. Every reader converts its log's convention to this (model/drive/attitude_convention.h).
struct InsSample {
  std::int64_t stamp_ns = 0;  ///< Unix time, UTC
  double latitude_rad = 0.0;
  double longitude_rad = 0.0;
  double height_m = 0.0;  ///< above the ellipsoid
  Eigen::Quaterniond enu_from_ins = Eigen::Quaterniond::Identity();
  InsSigma sigma;
  InsQuality quality = InsQuality::Unknown;
};

/// A pose with a stamp: what `pose` maps from and to is named by the variable that holds it.
struct StampedPose {
  std::int64_t stamp_ns = 0;
  RigidTransform pose = RigidTransform::Identity();
};

}  // namespace remount::motion
