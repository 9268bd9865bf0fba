// How a vehicle leaned along a drive, from its turn rates and the heights of its antenna.
#pragma once

#include <vector>

#include "algorithms/calibration/antenna/driven_positions.h"

namespace remount::calibration {

/// How the errors of leans and level ways along a drive hang together: each has a share of what is unknown of its
/// window and of what is unknown of the whole drive.
struct TiltErrors {
  using ByWindow = Eigen::Matrix<double, 2, 3>;
  using ByDrive = Eigen::Matrix<double, 2, 5>;
  struct OfPoint {
    std::size_t window = 0;
    ByWindow lean_by_window = ByWindow::Zero(), way_by_window = ByWindow::Zero();  ///< way: m, level axes of the window
    ByDrive lean_by_drive = ByDrive::Zero(), way_by_drive = ByDrive::Zero();
  };
  struct OfWindow {
    Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();  ///< covariance of its unknowns while those of the drive stand
    Eigen::Matrix<double, 3, 5> follows = Eigen::Matrix<double, 3, 5>::Zero();  ///< how they follow those of the drive
  };
  /// What is summed over the points: `by_lean` times the lean and `by_way` times the way.
  struct Factors {
    Eigen::Matrix2d by_lean = Eigen::Matrix2d::Zero(), by_way = Eigen::Matrix2d::Zero();
  };
  std::vector<OfPoint> points;
  std::vector<OfWindow> windows;
  Eigen::Matrix<double, 5, 5> drive_covariance = Eigen::Matrix<double, 5, 5>::Zero();

  Eigen::Matrix2d covariance_of_sum(const std::vector<Factors>& factors) const;
};

struct VehicleTilt {
  bool known = false;  ///< false: the log has a yaw rate only, or too little height; `up_in_vehicle` is then zero
  /// x and y of the vertical in vehicle axes (forward, left) at each position that wheels and rates cover, in order.
  std::vector<Eigen::Vector2d> up_in_vehicle;
  std::vector<Eigen::Matrix3d> level_from_window_start;  ///< vehicle axes, yaw left as it is
  double pitch_centre_m = 0.0;                           ///< ahead of the rear axle
  /// Way of the wheels in the axes that the IMU's mounting gives, for each metre of it.
  Eigen::Vector3d way = Eigen::Vector3d::UnitX();
  Eigen::Vector2d rate_bias_radps = Eigen::Vector2d::Zero();  ///< about x and y of the vehicle
  TiltErrors errors;  ///< of leans and ways where they are known, without the next
  /// Variance of an error of the lean to the side that is the same all along the drive, rad^2.
  double common_roll_variance_rad2 = 0.0;
};

/// The rates say how the lean changes, and the heights which way is up: where the vehicle drives along x it climbs by
/// the sine of its pitch, and as it turns, what was roll becomes pitch. Each window has its own vertical; biases of the
/// roll and pitch rates, the way of the wheels in the axes of the rates and the pitch centre are common. Not known
/// without roll and pitch rates, or where heights tell less than what roads fall to one side by: a percent.
/// docs/maths/vehicle-frame.md (V13), (V17)
/// @param one_axis whether the rates are about a single axis, as of a yaw-rate sensor
/// @param imu_roll_sigma_rad how well the roll of `vehicle_from_imu` is known, which heights do not show
VehicleTilt vehicle_tilt(const std::vector<DrivenPosition>& driven, bool one_axis,
                         const Eigen::Matrix3d& vehicle_from_imu, double imu_roll_sigma_rad,
                         const Eigen::Vector2d& lever_m, const Progress& progress);

}  // namespace remount::calibration
