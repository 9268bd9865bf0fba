// Residuals of the vehicle-frame calibration and their least squares; used by vehicle_frame.cpp and its tests.
#pragma once

#include <array>
#include <vector>

#include "algorithms/calibration/observability.h"
#include "algorithms/calibration/vehicle_frame/vehicle_frame.h"

namespace remount::calibration {

/// Everything that is estimated at once. The tangent has kUnknowns entries in the order of the members.
struct VehicleFrameState {
  static constexpr int kUnknowns = 24;
  RigidTransform vehicle_from_sensor = RigidTransform::Identity();       // 0-5, `perturb`
  double log_scale = 0.0;                                                // 6, sensor
  double log_wheel_scale = 0.0;                                          // 7
  Eigen::Vector3d gyro_bias_radps = Eigen::Vector3d::Zero();             // 8-10, axes of the IMU
  Eigen::Matrix3d vehicle_from_imu = Eigen::Matrix3d::Identity();        // 11-13, left
  double track_m = 1.6;                                                  // 14, distance of the rear wheels
  Eigen::Matrix3d vehicle_from_reference = Eigen::Matrix3d::Identity();  // 15-17, left
  double pitch_centre_m = 0.0;                                           // 18, ahead of the rear axle
  double log_gyro_scale = 0.0;                                           // 19, of all axes of the IMU
  Eigen::Vector3d gyro_scale_apart = Eigen::Vector3d::Zero();            // 20-22, of each axis beyond that
  double wheel_asymmetry = 0.0;  // 23, share by which the right wheel's way is longer than said, the left's shorter

  Eigen::Vector3d log_gyro_scales() const { return gyro_scale_apart.array() + log_gyro_scale; }
};
using StateVector = Eigen::Matrix<double, VehicleFrameState::kUnknowns, 1>;
using StateMatrix = Eigen::Matrix<double, VehicleFrameState::kUnknowns, VehicleFrameState::kUnknowns>;

VehicleFrameState state_after(const VehicleFrameState& state, const StateVector& delta);
/// The delta with state_after(from, delta) == to.
StateVector state_difference(const VehicleFrameState& from, const VehicleFrameState& to);

/// What is wrong with the rates of the IMU: bias (rad/s), then the logarithm of true rates per measured ones.
using RateErrors = Vector6d;
RateErrors rate_errors(const VehicleFrameState& state);

/// One interval with its integration, linear in the errors of the rates about `errors`.
struct IntegratedInterval {
  const VehicleInterval* interval = nullptr;
  RateErrors errors = RateErrors::Zero();
  motion::WheelPreintegration nominal;
  struct Slope {
    Eigen::Vector3d turn;      ///< of Log(imu_start_from_imu_end) to the left
    Eigen::Vector3d turn_sum;  ///< of turn_in_imu_rad
    Eigen::Matrix3d map, difference_map;
    std::array<Eigen::Matrix3d, 3> turn_maps;
  };
  std::array<Slope, 6> by_error;
};
IntegratedInterval integrate(const VehicleInterval& interval, const RateErrors& errors);

/// Kinds of residuals, each with a noise of its own that is estimated from them.
enum ResidualKind { kWay, kTurn, kWheelDifference, kReferenceTurn, kLevel, kResidualKinds };
inline constexpr std::array<int, kResidualKinds> kResidualRows{3, 3, 1, 3, 1};
inline constexpr int kAllRows = 11;
using IntervalResidual = Eigen::Matrix<double, kAllRows, 1>;
using IntervalJacobian = Eigen::Matrix<double, kAllRows, VehicleFrameState::kUnknowns>;

/// P X = X Q in translation (m) and rotation (rad), wheel difference (m), turn against the reference (rad), and turn
/// about the vehicle's y (rad), in this order. A turn about x is no error of the level: a road that climbs as it turns
/// makes it, and the sensor's own way along the axis of its turn shows it.
IntervalResidual residual_of(const IntegratedInterval& interval, const VehicleFrameState& state);
/// By central differences: the closed forms of all blocks are smooth.
IntervalJacobian jacobian_of(const IntegratedInterval& interval, const VehicleFrameState& state);

struct VehicleFrameProblem {
  const std::vector<VehicleInterval>* intervals = nullptr;
  std::array<bool, kResidualKinds> used{};
  using Free = Eigen::Array<bool, VehicleFrameState::kUnknowns, 1>;
  Free free = Free::Constant(false);
  VehicleFrameState prior;
  StateVector prior_sigma = StateVector::Ones();  ///< of the free unknowns
};

struct VehicleFrameSolution {
  VehicleFrameState state;
  bool converged = false, cancelled = false;
  std::array<double, kResidualKinds> sigma{};     ///< of one row of each kind
  StateMatrix information = StateMatrix::Zero();  ///< of all unknowns, prior included; held ones have a row of zeros
  StateMatrix covariance = StateMatrix::Zero();   ///< held ones zero; widened where errors last longer than an interval
  SpuriousInformation excitation;                 ///< of X, other unknowns marginalised, without the prior
  int outliers = 0;                               ///< intervals of little weight
};

/// Robust Gauss-Newton with the noise of each kind estimated from its residuals.
VehicleFrameSolution solve_problem(const VehicleFrameProblem& problem, const VehicleFrameState& start,
                                   const Progress& progress);

/// Covariance of X by the information that is trusted along `directions` and the prior; of no unknown less than
/// `widened` says. Widening leaves directions less information than the prior alone; these are dropped, and what leans
/// on them would be stated as if nothing had been widened.
/// @param widened of X, as in VehicleFrameSolution
Matrix6d stated_covariance(const Matrix6d& widened, const Vector6d& prior_information,
                           const std::vector<ObservabilityDirection>& directions, const SolveOptions& solve);

}  // namespace remount::calibration
