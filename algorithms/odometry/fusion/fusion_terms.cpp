#include "algorithms/odometry/fusion/fusion_terms.h"

#include <cmath>

namespace remount::odometry {
namespace {

Eigen::Vector3d correction_turn(const FusionVector& x) { return x.segment<3>(kCorrection + 3); }
Eigen::Vector3d motion_turn(const FusionVector& x) { return x.segment<3>(kMotion + 3); }

}  // namespace

RigidTransform moved_pose(const StepAnchor& anchor, const FusionVector& x) {
  return perturb(anchor.predicted, x.segment<6>(kMotion));
}

Matrix6d carried_to_prediction(const StepAnchor& anchor) {
  Matrix6d carried = Matrix6d::Identity();
  carried.topRightCorner<3, 3>() = -skew(anchor.predicted.translation() - anchor.before.translation());
  return carried;
}

RigidTransform pose_in_map(const StepAnchor& anchor, const FusionVector& x) {
  return perturb(anchor.predicted, x.segment<6>(kMotion) + carried_to_prediction(anchor) * x.segment<6>(kInMap));
}

RigidTransform fused_pose(const StepAnchor& anchor, const FusionVector& x) {
  const RigidTransform moved = moved_pose(anchor, x);
  const Eigen::Matrix3d turn = so3_exp(correction_turn(x));
  const Eigen::Vector3d pivot = anchor.before.translation();
  return make_rigid(turn * moved.linear(), pivot + x.segment<3>(kCorrection) + turn * (moved.translation() - pivot));
}

Eigen::Matrix<double, 6, kFusionUnknowns> fused_pose_jacobian(const StepAnchor& anchor, const FusionVector& x) {
  const Eigen::Matrix3d turn = so3_exp(correction_turn(x));
  const Eigen::Matrix3d correction_jacobian = so3_left_jacobian(correction_turn(x));
  const Eigen::Vector3d arm = turn * (moved_pose(anchor, x).translation() - anchor.before.translation());
  Eigen::Matrix<double, 6, kFusionUnknowns> jacobian = Eigen::Matrix<double, 6, kFusionUnknowns>::Zero();
  jacobian.block<3, 3>(0, kCorrection).setIdentity();
  jacobian.block<3, 3>(0, kCorrection + 3) = -skew(arm) * correction_jacobian;
  jacobian.block<3, 3>(0, kMotion) = turn;
  jacobian.block<3, 3>(3, kCorrection + 3) = correction_jacobian;
  jacobian.block<3, 3>(3, kMotion + 3) = turn * so3_left_jacobian(motion_turn(x));
  return jacobian;
}

FeatureTerm::FeatureTerm(Kind kind, const StepAnchor& anchor, std::vector<FeatureMatch> matches,
                         std::vector<double> weights, const Matrix6d& heard)
    : kind_(kind),
      anchor_(anchor),
      matches_(std::move(matches)),
      weights_(std::move(weights)),
      heard_(heard),
      carried_(carried_to_prediction(anchor)) {}

int FeatureTerm::rows() const { return static_cast<int>(matches_.size()) * (kind_ == Kind::Lines ? 2 : 1); }

void FeatureTerm::evaluate(const FusionVector& x, Eigen::Ref<Eigen::VectorXd> residuals,
                           FusionJacobian* jacobian) const {
  const Vector6d heard = heard_ * (x.segment<6>(kMotion) + carried_ * x.segment<6>(kInMap));
  const RigidTransform odometry_from_vehicle = perturb(anchor_.predicted, heard);
  const Eigen::Matrix3d turn_jacobian = so3_left_jacobian(heard.tail<3>());
  if (jacobian) jacobian->setZero();
  const auto fill = [&](Eigen::Index row, const FeatureMatch& match, const Eigen::Vector3d& arm,
                        const Eigen::Vector3d& axis, double weight) {
    const Eigen::Vector3d point = odometry_from_vehicle.translation() + arm;
    residuals[row] = weight * axis.dot(point - match.centre);
    if (!jacobian) return;
    Eigen::Matrix<double, 1, 6> slope;
    slope << axis.transpose(), arm.cross(axis).transpose() * turn_jacobian;
    const Eigen::Matrix<double, 1, 6> heard_slope = weight * slope * heard_;
    jacobian->block<1, 6>(row, kMotion) = heard_slope;
    jacobian->block<1, 6>(row, kInMap).noalias() = heard_slope * carried_;
  };
  for (std::size_t i = 0; i < matches_.size(); ++i) {
    const FeatureMatch& match = matches_[i];
    const Eigen::Vector3d arm = odometry_from_vehicle.linear() * match.point_in_vehicle;
    const auto row = static_cast<Eigen::Index>(i);
    if (kind_ == Kind::Planes) {
      fill(row, match, arm, match.direction, weights_[i]);
    } else {
      const Eigen::Vector3d across = match.direction.unitOrthogonal();
      fill(2 * row, match, arm, across, weights_[i]);
      fill(2 * row + 1, match, arm, match.direction.cross(across), weights_[i]);
    }
  }
}

TurnTerm::TurnTerm(const StepAnchor& anchor, const Eigen::Matrix3d& before_from_after, double duration_s,
                   const Eigen::Vector3d& sigma_rad, bool has_bias)
    : anchor_(anchor),
      after_from_before_(before_from_after.transpose()),
      bias_factor_s_(has_bias ? duration_s : 0.0),
      sigma_rad_(sigma_rad) {}

void TurnTerm::evaluate(const FusionVector& x, Eigen::Ref<Eigen::VectorXd> residuals, FusionJacobian* jacobian) const {
  const Eigen::Matrix3d measured_from_odometry = after_from_before_ * anchor_.before.linear().transpose();
  const Eigen::Vector3d error = so3_log(measured_from_odometry * moved_pose(anchor_, x).linear());
  // The gyroscope turned too far by its bias; over one step the rotation is small enough for the first order.
  residuals = (error + bias_factor_s_ * x.segment<3>(kDrift)).cwiseQuotient(sigma_rad_);
  if (!jacobian) return;
  jacobian->setZero();
  jacobian->block<3, 3>(0, kMotion + 3) =
      sigma_rad_.cwiseInverse().asDiagonal() *
      (so3_left_jacobian_inverse(error) * measured_from_odometry * so3_left_jacobian(motion_turn(x)));
  jacobian->block<3, 3>(0, kDrift) = (bias_factor_s_ * sigma_rad_.cwiseInverse()).asDiagonal();
}

TravelTerm::TravelTerm(const StepAnchor& anchor, const Eigen::Vector3d& travel_in_before_m,
                       const Eigen::Vector3d& sigma_m, bool has_scale)
    : anchor_(anchor), travel_m_(travel_in_before_m), sigma_m_(sigma_m), scale_factor_(has_scale ? 1.0 : 0.0) {}

void TravelTerm::evaluate(const FusionVector& x, Eigen::Ref<Eigen::VectorXd> residuals,
                          FusionJacobian* jacobian) const {
  const Eigen::Matrix3d before_from_odometry = anchor_.before.linear().transpose();
  const Eigen::Vector3d travelled =
      before_from_odometry * (moved_pose(anchor_, x).translation() - anchor_.before.translation());
  residuals = (travelled - travel_m_ * (1.0 + scale_factor_ * x[kDrift + 3])).cwiseQuotient(sigma_m_);
  if (!jacobian) return;
  jacobian->setZero();
  jacobian->block<3, 3>(0, kMotion) = sigma_m_.cwiseInverse().asDiagonal() * before_from_odometry;
  jacobian->col(kDrift + 3) = -scale_factor_ * travel_m_.cwiseQuotient(sigma_m_);
}

void FilteredTerm::evaluate(const FusionVector& x, Eigen::Ref<Eigen::VectorXd> residuals,
                            FusionJacobian* jacobian) const {
  FusionVector filtered = x;
  filtered.segment<6>(kMotion) = speaks_ * x.segment<6>(kMotion);
  term_->evaluate(filtered, residuals, jacobian);
  if (jacobian) jacobian->middleCols<6>(kMotion) *= speaks_;
}

LevelMeasurement level_from_gravity(const Eigen::Vector3d& up) {
  return {std::atan2(up.y(), up.z()), std::atan2(-up.x(), up.tail<2>().norm()), 0.0, 0.0};
}

void LevelTerm::evaluate(const FusionVector& x, Eigen::Ref<Eigen::VectorXd> residuals, FusionJacobian* jacobian) const {
  const YawPitchRoll angles = yaw_pitch_roll_from_rotation(fused_pose(anchor_, x).linear());
  residuals << wrap_angle_rad(angles.roll_rad - measured_.roll_rad - x[kSteady]) / measured_.roll_sigma_rad,
      (angles.pitch_rad - measured_.pitch_rad - x[kSteady + 1]) / measured_.pitch_sigma_rad;
  if (!jacobian) return;
  const Eigen::Matrix3d by_turn = yaw_pitch_roll_jacobian(angles);  // rows yaw, pitch, roll
  const Eigen::Matrix<double, 3, kFusionUnknowns> turn = fused_pose_jacobian(anchor_, x).bottomRows<3>();
  jacobian->row(0) = by_turn.row(2) * turn / measured_.roll_sigma_rad;
  jacobian->row(1) = by_turn.row(1) * turn / measured_.pitch_sigma_rad;
  (*jacobian)(0, kSteady) = -1.0 / measured_.roll_sigma_rad;
  (*jacobian)(1, kSteady + 1) = -1.0 / measured_.pitch_sigma_rad;
}

void HeightTerm::evaluate(const FusionVector& x, Eigen::Ref<Eigen::VectorXd> residuals,
                          FusionJacobian* jacobian) const {
  residuals[0] = (fused_pose(anchor_, x).translation().z() - height_m_) / sigma_m_;
  if (!jacobian) return;
  jacobian->setZero();
  jacobian->row(0).leftCols<12>() = fused_pose_jacobian(anchor_, x).row(2).leftCols<12>() / sigma_m_;
}

void LinearFusionTerm::evaluate(const FusionVector& x, Eigen::Ref<Eigen::VectorXd> residuals,
                                FusionJacobian* jacobian) const {
  residuals = root_ * (x - expected_);
  if (jacobian) *jacobian = root_;
}

}  // namespace remount::odometry
