// Errors that stay the same from scan to scan in the multi-sensor odometry: no number of scans averages them away.
#pragma once

#include <Eigen/Core>
#include <optional>

#include "algorithms/odometry/fusion_options.h"
#include "algorithms/odometry/fusion_step_parts.h"

namespace remount {

using StateCovariance = Eigen::Matrix<double, 10, 10>;  ///< of pose (`perturbed`) and drift

/// How the estimate answers to a steady error of the accelerometer's roll, of its pitch and of the barometer's height:
/// carried along beside the least squares, which weighs their scans as independent (a "consider" filter).
class CommonErrors {
 public:
  explicit CommonErrors(const FusionOptions& options) : options_(options) {}

  /// The first pose took roll and pitch from the accelerometer.
  void levelled_at_start() { response_(3, 0) = response_(4, 1) = 1.0; }
  /// Heights are measured from a pose whose own height is only that certain.
  void height_starts(double sigma_m) { height_start_sigma_m_ = sigma_m; }

  /// @param covariance of the step's solution; nothing where it could not be solved
  /// @param prior_information of what was known before, over the step's unknowns
  void step(const StepAnchor& anchor, const FusionVector& x, const std::optional<FusionInformation>& covariance,
            const FusionInformation& prior_information, const std::optional<LevelMeasurement>& level,
            const std::optional<HeightTerm>& height);

  /// What these errors add to the covariance of pose and drift.
  StateCovariance covariance() const;

 private:
  FusionOptions options_;
  Eigen::Matrix<double, 10, 3> response_ = Eigen::Matrix<double, 10, 3>::Zero();
  double height_start_sigma_m_ = 0.0;
};

/// Covariance of pose and drift after a step that only the prediction tells of: it grows by what that is worth.
/// @param step_covariance of the motion, as `step_covariance_of`
StateCovariance grown_covariance(const StateCovariance& before, const StepAnchor& anchor, const FusionVector& x,
                                 const Matrix6d& step_covariance);
/// In odometry axes.
Matrix6d step_covariance_of(const MotionSigma& sigma, const StepAnchor& anchor);
/// d (pose after the step, drift) / d x.
Eigen::Matrix<double, 10, 16> state_jacobian(const StepAnchor& anchor, const FusionVector& x);

}  // namespace remount
