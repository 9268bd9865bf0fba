// The errors that enter P X = X Q, and how large they turn out to be.
#pragma once

#include "algorithms/geometry/rigid_transform.h"

namespace remount::calibration {

/// Error model of a drive. INS poses carry errors that are independent from keyframe to keyframe, so the same fix
/// enters every pair that uses it, and an attitude error that stays the same over the drive, which no residual shows.
/// On top of these INS poses drift: position and attitude errors walk randomly, so that a short gap hardly shows what a
/// long one does. Registrations carry `registration_scale`^2 times the inverse of their information, and a floor for
/// what the information does not know (discretisation, distortion of the scans). A share of the former comes with the
/// scans, whose range noise is the same in all their pairs.
struct NoiseModel {
  double ins_position_sigma_m = 0.01;
  double ins_attitude_sigma_rad = 5e-4;
  double registration_scale = 3.0;
  double registration_floor_m = 1.5e-3;
  double registration_floor_rad = 1e-4;
  double ins_position_drift = 0.0;  ///< m per root of a second; 0: none
  double ins_attitude_drift = 0.0;  ///< rad per root of a second; 0: none

  /// Share of the registrations' variance that comes with scans that are in several pairs.
  static constexpr double kScanShare = 0.5;

  /// All sigmas times a factor.
  NoiseModel times(double factor) const;
  bool drifts() const { return ins_position_drift > 0.0 || ins_attitude_drift > 0.0; }
  /// Covariance of the drift [nu; omega] over a time.
  Matrix6d drift_covariance(double gap_s) const;
  /// Covariance of an INS pose error [nu; omega], independent from keyframe to keyframe.
  Matrix6d ins_covariance() const;
  /// The same with what a scan brings (JointNode::scan_covariance).
  Matrix6d node_covariance(const Matrix6d& scan_covariance) const;
  /// Information (inverse covariance) of a registration: also where `information` is singular.
  /// @param share of the variance; the floor is always whole
  Matrix6d registration_information(const Matrix6d& information, double share = 1.0) const;
};

}  // namespace remount::calibration
