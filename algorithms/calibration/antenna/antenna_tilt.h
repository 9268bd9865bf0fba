// How a vehicle leaned along a drive, from its turn rates and the heights of its antenna.
#pragma once

#include <vector>

#include "algorithms/calibration/antenna/antenna_fit.h"

namespace remount {

struct VehicleTilt {
  bool known = false;  ///< false: the log has a yaw rate only, or too little height; `up_in_vehicle` is then zero
  /// x and y of the vertical in vehicle axes (forward, left) at each position that wheels and rates cover, in order.
  std::vector<Eigen::Vector2d> up_in_vehicle;
  std::vector<Eigen::Matrix3d> level_from_window_start;       ///< vehicle axes, yaw left as it is
  Eigen::Vector2d rate_bias_radps = Eigen::Vector2d::Zero();  ///< about x and y of the vehicle
  /// Of an error that is the same all along the drive, rad^2.
  Eigen::Matrix2d common_covariance = Eigen::Matrix2d::Zero();
};

/// The rates say how the lean changes, and the heights which way is up: where the vehicle drives along x it climbs by
/// the sine of its pitch, and as it turns, what was roll becomes pitch. Windows as in `fit_antenna`, each with its own
/// vertical; biases of the roll and pitch rates and the pitch of the wheels' way against the axes of the rates are
/// common. Not known: a built road falls to one side by a percent, and no more is claimed.
VehicleTilt vehicle_tilt(const WheelImuSignals& sensed, const std::vector<StampedPosition>& positions,
                         const Eigen::Matrix3d& vehicle_from_imu, double window_s, const Eigen::Vector2d& lever_m,
                         const Progress& progress);

}  // namespace remount
