#include "algorithms/odometry/fusion/state_errors.h"

#include <algorithm>
#include <cmath>

namespace remount::odometry {
namespace {

constexpr double kExact = 1e-5;  // m, rad: by definition of the map

// What is known before a step, among its unknowns: the correction of the pose, the drift, the place in the map.
template <class State>
auto among_unknowns(const State& state) {
  Eigen::Matrix<double, kFusionUnknowns, State::ColsAtCompileTime> result =
      Eigen::Matrix<double, kFusionUnknowns, State::ColsAtCompileTime>::Zero();
  result.template topRows<6>() = state.template topRows<6>();
  result.template bottomRows<12>() = state.template bottomRows<12>();
  return result;
}

// How a height that errs by one pulls at the unknowns.
FusionVector height_pull(const HeightTerm& height, const FusionVector& x) {
  Eigen::VectorXd residual(1);
  FusionJacobian jacobian(1, kFusionUnknowns);
  height.evaluate(x, residual, &jacobian);
  return jacobian.row(0).transpose() / height.sigma_m();
}

// Errors of a pose as they show in the motion from a place behind it.
Matrix6d seen_from(const Eigen::Vector3d& arm) {
  Matrix6d result = Matrix6d::Identity();
  result.topRightCorner<3, 3>() = skew(arm);
  return result;
}

}  // namespace

Eigen::Matrix<double, kErrorStates, kFusionUnknowns> state_jacobian(const StepAnchor& anchor, const FusionVector& x) {
  Eigen::Matrix<double, kErrorStates, kFusionUnknowns> jacobian =
      Eigen::Matrix<double, kErrorStates, kFusionUnknowns>::Zero();
  jacobian.topRows<6>() = fused_pose_jacobian(anchor, x);
  jacobian.block<4, 4>(kStateDrift, kDrift).setIdentity();
  jacobian.block<6, 6>(kStateInMap, kMotion).setIdentity();
  jacobian.block<6, 6>(kStateInMap, kInMap) = carried_to_prediction(anchor);
  jacobian.block<2, 2>(kStateSteady, kSteady).setIdentity();
  return jacobian;
}

Matrix6d step_covariance_of(const MotionSigma& sigma, const StepAnchor& anchor) {
  const Eigen::Matrix3d axes = anchor.before.linear();
  Matrix6d covariance = Matrix6d::Zero();
  covariance.topLeftCorner<3, 3>() = axes * sigma.travel_m.cwiseAbs2().asDiagonal() * axes.transpose();
  covariance.bottomRightCorner<3, 3>() = axes * sigma.turn_rad.cwiseAbs2().asDiagonal() * axes.transpose();
  return covariance;
}

StateCovariance grown_covariance(const StateCovariance& before, const StepAnchor& anchor, const FusionVector& x,
                                 const Matrix6d& motion_covariance) {
  const Eigen::Matrix<double, kFusionUnknowns, kErrorStates> rows = among_unknowns(before);
  FusionInformation joint = among_unknowns(Eigen::Matrix<double, kErrorStates, kFusionUnknowns>(rows.transpose()));
  joint.block<6, 6>(kMotion, kMotion) = motion_covariance;
  const Eigen::Matrix<double, kErrorStates, kFusionUnknowns> now = state_jacobian(anchor, x);
  return now * joint * now.transpose();
}

void StateErrors::start(const std::optional<LevelMeasurement>& level, bool level_is_open) {
  constexpr double kNone = 1e-4, kOpen_rad = 0.05, kLeast = 1e-8;
  Eigen::Matrix<double, kErrorStates, 1> sigma = Eigen::Matrix<double, kErrorStates, 1>::Constant(kNone);
  if (level_is_open) sigma[3] = sigma[4] = kOpen_rad;
  sigma.segment<3>(kStateDrift).setConstant(std::max(degrees_to_radians(options_.gyro_bias_sigma_dps), kLeast));
  sigma[kStateDrift + 3] = std::max(options_.wheel_scale_sigma, kLeast);
  sigma.segment<6>(kStateInMap).setConstant(kExact);
  const double bias_rad = std::max(degrees_to_radians(options_.accelerometer_bias_deg), kLeast);
  sigma.segment<2>(kStateSteady).setConstant(bias_rad);
  if (level) {
    sigma[3] = std::hypot(level->roll_sigma_rad, bias_rad);
    sigma[4] = std::hypot(level->pitch_sigma_rad, bias_rad);
  }
  covariance_ = sigma.cwiseAbs2().asDiagonal();
  if (!level) return;
  for (int i = 0; i < 2; ++i)
    covariance_(3 + i, kStateSteady + i) = covariance_(kStateSteady + i, 3 + i) = bias_rad * bias_rad;
}

FusionJacobian StateErrors::prior_root(double duration_s) const {
  StateCovariance covariance = covariance_;
  const double walk = degrees_to_radians(options_.gyro_bias_walk_dps);
  covariance.diagonal().segment<3>(kStateDrift).array() += walk * walk * duration_s;
  const Eigen::MatrixXd root = root_information(covariance);
  FusionJacobian rows = FusionJacobian::Zero(kErrorStates, kFusionUnknowns);
  rows.leftCols<6>() = root.leftCols(6);
  rows.rightCols<12>() = root.rightCols(12);
  return rows;
}

void StateErrors::entered_map(std::size_t frames) {
  // A map that is the mean of the last n scans moves with each of them as one that forgets 2 / (n + 1) of itself. Their
  // errors are not independent: they share the surfaces and each other's errors for as long as a scan stays in the map,
  // and n such errors add up to n times the variance.
  const double most = options_.map_frames;
  const double share = std::max(1.0 / static_cast<double>(frames), 2.0 * std::sqrt(most) / (most + 1.0));
  const double kept = 1.0 - std::min(1.0, share);
  response_.segment<6>(kStateInMap) *= kept;
  covariance_.middleRows<6>(kStateInMap) *= kept;
  covariance_.middleCols<6>(kStateInMap) *= kept;
  for (Mark& mark : marks_) mark.shared.middleRows<6>(kStateInMap) *= kept;
  covariance_.diagonal().segment<6>(kStateInMap) =
      covariance_.diagonal().segment<6>(kStateInMap).cwiseMax(kExact * kExact);
}

void StateErrors::new_map() {
  response_.segment<6>(kStateInMap).setZero();
  covariance_.middleRows<6>(kStateInMap).setZero();
  covariance_.middleCols<6>(kStateInMap).setZero();
  covariance_.diagonal().segment<6>(kStateInMap).setConstant(kExact * kExact);
  for (Mark& mark : marks_) mark.shared.middleRows<6>(kStateInMap).setZero();
}

void StateErrors::step(const StepAnchor& anchor, const FusionVector& x, double duration_s,
                       const std::optional<FusionInformation>& solved, const std::optional<HeightTerm>& height,
                       const Matrix6d& motion_covariance) {
  const auto now = state_jacobian(anchor, x);
  const auto known_before = among_unknowns(StateCovariance::Identity().eval());
  StateCovariance of_before = now * known_before;
  Eigen::Matrix<double, kErrorStates, 1> of_height = Eigen::Matrix<double, kErrorStates, 1>::Zero();
  if (solved) {
    // The solution is covariance * sum of information * measured: each errs into it by its share.
    // docs/maths/fusion-odometry.md (O12)
    const FusionJacobian root = prior_root(duration_s);
    of_before = now * *solved * (root.transpose() * root) * known_before;
    if (height) of_height = now * *solved * height_pull(*height, x);
    covariance_ = now * *solved * now.transpose();
  } else {
    covariance_ = grown_covariance(covariance_, anchor, x, motion_covariance);
  }
  response_ = of_before * response_ + of_height;
  for (Mark& mark : marks_) mark.shared = of_before * mark.shared;
}

void StateErrors::mark(std::size_t number, const RigidTransform& odometry_from_vehicle) {
  marks_.resize(std::max(marks_.size(), number + 1));
  marks_[number] = {odometry_from_vehicle, covariance_.topLeftCorner<6, 6>(), response_.head<6>(),
                    covariance_.leftCols<6>()};
}

Matrix6d StateErrors::covariance_since(std::size_t number, const RigidTransform& odometry_from_vehicle) const {
  const Mark& then = marks_.at(number);
  const Matrix6d shared = then.shared.topRows<6>();
  const Matrix6d carried = seen_from(then.odometry_from_vehicle.translation() - odometry_from_vehicle.translation());
  const Vector6d response = response_.head<6>() - carried * then.response;
  return covariance_.topLeftCorner<6, 6>() + carried * then.covariance * carried.transpose() -
         shared * carried.transpose() - carried * shared.transpose() + steady_m2() * response * response.transpose();
}

}  // namespace remount::odometry
