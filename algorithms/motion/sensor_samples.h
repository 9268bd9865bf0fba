// What the other sensors of a vehicle report: IMU, GNSS receiver, wheels, barometer, joints of an arm.
#pragma once

#include <Eigen/Core>
#include <cstdint>

namespace remount::motion {

/// Inertial measurement, in the axes of the IMU. An IMU at rest and level (x forward, y left, z up) reads a specific
/// force of +9.8 m/s^2 along z.
struct ImuSample {
  std::int64_t stamp_ns = 0;  ///< Unix time, UTC
  Eigen::Vector3d angular_rate_radps = Eigen::Vector3d::Zero();
  Eigen::Vector3d specific_force_mps2 = Eigen::Vector3d::Zero();  ///< NaN where the log has rates only
};

/// Position of the antenna as a GNSS receiver reports it; no attitude.
struct GnssFix {
  std::int64_t stamp_ns = 0;  ///< Unix time, UTC
  double latitude_rad = 0.0;
  double longitude_rad = 0.0;
  double height_m = 0.0;                                            ///< above the ellipsoid
  Eigen::Matrix3d covariance_enu_m2 = Eigen::Matrix3d::Identity();  ///< as the receiver states it
};

/// Speed of the ground under the rear wheels, positive forwards.
struct WheelSample {
  std::int64_t stamp_ns = 0;  ///< Unix time, UTC
  double rear_left_mps = 0.0;
  double rear_right_mps = 0.0;
};

/// Height from air pressure, up to an unknown constant.
struct BarometerSample {
  std::int64_t stamp_ns = 0;  ///< Unix time, UTC
  double height_m = 0.0;
};

}  // namespace remount::motion
