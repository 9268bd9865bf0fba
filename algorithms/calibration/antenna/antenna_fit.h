// Where an antenna sits on a vehicle, from its positions against wheels and yaw rate: for drives without any attitude.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "algorithms/calibration/antenna/driven_positions.h"
#include "algorithms/calibration/calibration_result.h"
#include "algorithms/core/progress.h"
#include "algorithms/messages/message.h"
#include "algorithms/motion/wheel_integration.h"

namespace remount::calibration {

struct AntennaFit {
  bool found = false;
  Status failure = Status::NotConverged;                           ///< what it is called where it is not
  Message why;                                                     ///< and in words
  Eigen::Vector2d antenna_in_vehicle_m = Eigen::Vector2d::Zero();  ///< x forward, y left of the rear axle's centre
  Eigen::Matrix2d covariance_m2 = Eigen::Matrix2d::Zero();
  double yaw_rate_bias_radps = 0.0, yaw_rate_bias_sigma_radps = 0.0;
  double wheel_scale = 1.0, wheel_scale_sigma = 0.0;
  double rms_m = 0.0;  ///< of the positions about the integrated drive
  int windows = 0;     ///< stretches of the drive, each placed anew
  std::size_t positions = 0;
  double distance_m = 0.0;  ///< driven, by the wheels
  /// Positions by integration from the start alone, with bias and scale taken out, and as measured; level frame.
  std::vector<StampedPosition> integrated, integrated_raw;
  double end_error_m = 0.0, end_error_raw_m = 0.0;  ///< after `integrated_m`
  double integrated_m = 0.0;                        ///< way by the wheels up to the first gap of the signals
  std::optional<double> first_gap_s;                ///< since the start, where the integration ends before the drive
};

/// Planar: yaw rate about z of the vehicle (`vehicle_from_imu`) and way of the wheels. The drive is cut into windows of
/// `window_s` whose place and heading are free, so that drift of the heading within a window is all that must be small;
/// lever arm, yaw-rate bias and wheel scale are common. An antenna stands high, and moves sideways where the vehicle
/// leans: what rates and heights tell of that is taken out (antenna_tilt.h), the rest is in the sigma. Robust (Huber);
/// sigma allows for errors that last from position to position. A drive that hardly turns shows no lever arm: its sigma
/// is large then.
/// @param imu_roll_sigma_rad how well the roll of `vehicle_from_imu` is known; 0: exactly
AntennaFit fit_antenna(const motion::WheelImuSignals& sensed, const std::vector<StampedPosition>& positions,
                       const Eigen::Matrix3d& vehicle_from_imu, double imu_roll_sigma_rad, double window_s,
                       Progress& progress);

}  // namespace remount::calibration
