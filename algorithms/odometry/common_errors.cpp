#include "algorithms/odometry/common_errors.h"

namespace remount {
namespace {

// What is known before a step, among its unknowns: the correction of the pose, and the drift.
template <class State>
auto among_unknowns(const State& state) {
  Eigen::Matrix<double, 16, State::ColsAtCompileTime> result =
      Eigen::Matrix<double, 16, State::ColsAtCompileTime>::Zero();
  result.template topRows<6>() = state.template topRows<6>();
  result.template bottomRows<4>() = state.template bottomRows<4>();
  return result;
}

}  // namespace

Eigen::Matrix<double, 10, 16> state_jacobian(const StepAnchor& anchor, const FusionVector& x) {
  Eigen::Matrix<double, 10, 16> jacobian = Eigen::Matrix<double, 10, 16>::Zero();
  jacobian.topRows<6>() = fused_pose_jacobian(anchor, x);
  jacobian.bottomRightCorner<4, 4>().setIdentity();
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
                                 const Matrix6d& step_covariance) {
  const Eigen::Matrix<double, 16, 10> rows = among_unknowns(before);
  FusionInformation joint = among_unknowns(Eigen::Matrix<double, 10, 16>(rows.transpose()));
  joint.block<6, 6>(kMotion, kMotion) = step_covariance;
  const Eigen::Matrix<double, 10, 16> now = state_jacobian(anchor, x);
  return now * joint * now.transpose();
}

void CommonErrors::step(const StepAnchor& anchor, const FusionVector& x,
                        const std::optional<FusionInformation>& covariance, const FusionInformation& prior_information,
                        const std::optional<LevelMeasurement>& level, const std::optional<HeightTerm>& height) {
  Eigen::Matrix<double, 16, 3> answer = among_unknowns(response_);
  if (covariance) {
    // The solution is covariance * sum of J^T (measured): each measurement that errs by one pulls by its own J.
    Eigen::Matrix<double, 16, 3> pull = prior_information * answer;
    if (level) {
      Eigen::VectorXd residuals(2);
      FusionJacobian jacobian(2, 16);
      LevelTerm(anchor, *level).evaluate(x, residuals, &jacobian);
      pull.col(0) += jacobian.row(0).transpose() / level->roll_sigma_rad;
      pull.col(1) += jacobian.row(1).transpose() / level->pitch_sigma_rad;
    }
    if (height) {
      Eigen::VectorXd residual(1);
      FusionJacobian jacobian(1, 16);
      height->evaluate(x, residual, &jacobian);
      pull.col(2) += jacobian.row(0).transpose() / height->sigma_m();
    }
    answer = *covariance * pull;
  }
  response_ = state_jacobian(anchor, x) * answer;
}

StateCovariance CommonErrors::covariance() const {
  const double level_rad = degrees_to_radians(options_.accelerometer_bias_deg);
  const Eigen::Vector3d sigma(level_rad, level_rad, std::hypot(options_.barometer_drift_m, height_start_sigma_m_));
  return response_ * sigma.cwiseAbs2().asDiagonal() * response_.transpose();
}

}  // namespace remount
