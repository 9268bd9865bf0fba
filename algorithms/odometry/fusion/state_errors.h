// Errors of the multi-sensor odometry: what they are worth at each scan, and which of them scans have in common.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <optional>
#include <vector>

#include "algorithms/odometry/fusion/fusion_options.h"
#include "algorithms/odometry/fusion/fusion_step_parts.h"

namespace remount::odometry {

/// Of pose (0-5, `perturb`), drift (6-9: gyroscope's bias, wheels' scale), the pose within the local map (10-15,
/// likewise) and steady errors (16-17: of the accelerometer's roll and pitch). The map keeps what many
/// scans agree on, and that is where features find the vehicle: it errs with the vehicle, not independently of it.
inline constexpr int kErrorStates = 18, kStateDrift = 6, kStateInMap = 10, kStateSteady = 16;
using StateCovariance = Eigen::Matrix<double, kErrorStates, kErrorStates>;

/// Follows the errors through the steps: the covariance of those that are independent from scan to scan or estimated;
/// how the estimate answers to the barometer's steady error, which no number of scans averages away and which weather
/// changes too much to be estimated (a "consider" filter); and what errors have in common with those of earlier scans,
/// for motions between scans.
class StateErrors {
 public:
  explicit StateErrors(const FusionOptions& options) : options_(options) {}

  /// The first pose. Its heading and place are exact by definition; roll and pitch are, too, without `level`, unless
  /// something else is to find them.
  void start(const std::optional<LevelMeasurement>& level, bool level_is_open);
  /// Heights are measured from the pose as it is now, whose own height is only that certain.
  void height_starts() { height_start_m2_ = covariance_(2, 2); }
  /// The scan entered the map as the latest of so many.
  void entered_map(std::size_t frames);
  /// The map begins with the vehicle as it is now.
  void new_map();

  /// R with R^T R = information of what is known before a step, over the step's unknowns.
  FusionJacobian prior_root(double duration_s) const;

  /// @param solved covariance of the step's solution; nothing where it could not be solved
  /// @param motion_covariance of the motion by prediction, `step_covariance_of`, for that case
  void step(const StepAnchor& anchor, const FusionVector& x, double duration_s,
            const std::optional<FusionInformation>& solved, const std::optional<HeightTerm>& height,
            const Matrix6d& motion_covariance);

  /// Of all errors.
  StateCovariance covariance() const { return covariance_ + steady_m2() * response_ * response_.transpose(); }

  /// Errors of the motion since the pose as it is now are followed from here on, under this number from 0.
  void mark(std::size_t number, const RigidTransform& odometry_from_vehicle);
  /// Covariance of the motion since a mark: of shift (m) and turn (rad), in axes of the odometry.
  Matrix6d covariance_since(std::size_t number, const RigidTransform& odometry_from_vehicle) const;

 private:
  struct Mark {
    RigidTransform odometry_from_vehicle = RigidTransform::Identity();
    Matrix6d covariance = Matrix6d::Zero();  // of the pose, but for the steady error of heights
    Vector6d response = Vector6d::Zero();    // of the pose to that
    Eigen::Matrix<double, kErrorStates, 6> shared = Eigen::Matrix<double, kErrorStates, 6>::Zero();  // with those now
  };

  double steady_m2() const { return options_.barometer_drift_m * options_.barometer_drift_m + height_start_m2_; }

  FusionOptions options_;
  Eigen::Matrix<double, kErrorStates, 1> response_ = Eigen::Matrix<double, kErrorStates, 1>::Zero();
  double height_start_m2_ = 0.0;
  StateCovariance covariance_ = StateCovariance::Zero();
  std::vector<Mark> marks_;
};

/// Covariance after a step that only the prediction tells of: it grows by what that is worth.
/// @param motion_covariance as `step_covariance_of`
StateCovariance grown_covariance(const StateCovariance& before, const StepAnchor& anchor, const FusionVector& x,
                                 const Matrix6d& motion_covariance);
/// In odometry axes.
Matrix6d step_covariance_of(const MotionSigma& sigma, const StepAnchor& anchor);
/// d (state after the step) / d x.
Eigen::Matrix<double, kErrorStates, kFusionUnknowns> state_jacobian(const StepAnchor& anchor, const FusionVector& x);

}  // namespace remount::odometry
