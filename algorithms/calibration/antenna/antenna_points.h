// The drive of an antenna on a vehicle, window by window: where wheels and rates lead to between the positions.
#pragma once

#include <vector>

#include "algorithms/calibration/antenna/antenna_tilt.h"

namespace remount::calibration {

/// One position with the motion since the start of its window, and how that changes with the bias of the yaw rate.
struct AntennaPoint {
  std::size_t window = 0;
  double time_s = 0.0, turn_rad = 0.0, travel_m = 0.0;  ///< since the start of the window
  Eigen::Vector2d way_m = Eigen::Vector2d::Zero(), way_by_bias = Eigen::Vector2d::Zero();
  Eigen::Vector2d position_m = Eigen::Vector2d::Zero();
  /// As the vehicle leans, with x where it heads.
  Eigen::Matrix<double, 2, 3> level_from_vehicle = Eigen::Matrix<double, 2, 3>::Identity();
};

/// Points of the drive under a bias of the yaw rate, one a position. Cancelled: fewer.
std::vector<AntennaPoint> antenna_points(const std::vector<DrivenPosition>& driven,
                                         const Eigen::Matrix3d& vehicle_from_imu, const VehicleTilt& tilt,
                                         double bias_radps, const Progress& progress);

/// Where the start of a window lies in the plane of the positions.
struct WindowPlacement {
  Eigen::Vector2d place_m = Eigen::Vector2d::Zero();
  double heading_rad = 0.0;
};

/// Of the window that the points from `first` to before `last` are of, by its ways alone.
WindowPlacement place_window(const std::vector<AntennaPoint>& points, std::size_t first, std::size_t last);
/// Of all windows, in their order.
std::vector<WindowPlacement> place_windows(const std::vector<AntennaPoint>& points);

Eigen::Matrix2d rotation_in_plane(double angle_rad);

}  // namespace remount::calibration
