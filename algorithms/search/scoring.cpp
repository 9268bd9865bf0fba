#include "algorithms/search/scoring.h"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <cmath>

namespace remount {
namespace {

using Vector9d = Eigen::Matrix<double, 9, 1>;

Vector9d entries(const Eigen::Matrix3d& rotation) { return Eigen::Map<const Vector9d>(rotation.data()); }

Eigen::Matrix3d pseudo_inverse(const Eigen::Matrix3d& symmetric, double relative_floor) {
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> eigen(symmetric);
  Eigen::Vector3d inverse = Eigen::Vector3d::Zero();
  for (int i = 0; i < 3; ++i)
    if (eigen.eigenvalues()[i] > relative_floor * eigen.eigenvalues()[2] && eigen.eigenvalues()[i] > 0.0)
      inverse[i] = 1.0 / eigen.eigenvalues()[i];
  return eigen.eigenvectors() * inverse.asDiagonal() * eigen.eigenvectors().transpose();
}

}  // namespace

double frobenius_sum(const std::vector<MotionPair>& pairs, const RigidTransform& ins_from_lidar,
                     double characteristic_length_m) {
  const double inverse_length2 = 1.0 / (characteristic_length_m * characteristic_length_m);
  double sum = 0.0;
  for (const MotionPair& pair : pairs) {
    const RigidTransform& p = pair.ins_b_from_ins_a;
    const RigidTransform& q = pair.lidar_b_from_lidar_a;
    const Eigen::Matrix3d rotation_error = p.linear() * ins_from_lidar.linear() - ins_from_lidar.linear() * q.linear();
    const Eigen::Vector3d translation_error =
        p * ins_from_lidar.translation() - ins_from_lidar * Eigen::Vector3d(q.translation());
    sum += std::sqrt(rotation_error.squaredNorm() + inverse_length2 * translation_error.squaredNorm());
  }
  return sum;
}

QuadraticForm::QuadraticForm(const std::vector<MotionPair>& pairs, double characteristic_length_m) {
  for (const MotionPair& pair : pairs) {
    const Eigen::Matrix3d r_p = pair.ins_b_from_ins_a.linear(), r_q = pair.lidar_b_from_lidar_a.linear();
    const Eigen::Vector3d t_q = pair.lidar_b_from_lidar_a.translation();
    Eigen::Matrix<double, 12, 13> error = Eigen::Matrix<double, 12, 13>::Zero();
    for (int column = 0; column < 3; ++column) {
      error.block<3, 3>(3 * column, 3 * column) += r_p;
      // Column c of R R_Q is the sum of R's columns weighted by column c of R_Q.
      for (int k = 0; k < 3; ++k) error.block<3, 3>(3 * column, 3 * k) -= r_q(k, column) * Eigen::Matrix3d::Identity();
      error.block<3, 3>(9, 3 * column) = -t_q[column] / characteristic_length_m * Eigen::Matrix3d::Identity();
    }
    error.block<3, 3>(9, 9) = (r_p - Eigen::Matrix3d::Identity()) / characteristic_length_m;
    error.block<3, 1>(9, 12) = pair.ins_b_from_ins_a.translation() / characteristic_length_m;
    form_.noalias() += pair.weight * error.transpose() * error;
  }
  constexpr double kRelativeFloor = 1e-9;
  translation_inverse_ = pseudo_inverse(form_.block<3, 3>(9, 9), kRelativeFloor);
  const Eigen::Matrix<double, 3, 9> t_from_r = form_.block<3, 9>(9, 0);
  const Eigen::Vector3d t_constant = form_.block<3, 1>(9, 12);
  reduced_quadratic_ = form_.block<9, 9>(0, 0) - t_from_r.transpose() * translation_inverse_ * t_from_r;
  reduced_linear_ = form_.block<9, 1>(0, 12) - t_from_r.transpose() * translation_inverse_ * t_constant;
  reduced_constant_ = form_(12, 12) - t_constant.dot(translation_inverse_ * t_constant);
}

double QuadraticForm::value(const RigidTransform& ins_from_lidar) const {
  Vector13d x;
  x << entries(ins_from_lidar.linear()), ins_from_lidar.translation(), 1.0;
  return x.dot(form_ * x);
}

Eigen::Vector3d QuadraticForm::best_translation_m(const Eigen::Matrix3d& rotation, const Eigen::Vector3d& near_m,
                                                  double relative_floor) const {
  const Eigen::Matrix3d block = form_.block<3, 3>(9, 9);
  const Eigen::Vector3d pull = form_.block<3, 9>(9, 0) * entries(rotation) + form_.block<3, 1>(9, 12);
  return near_m - pseudo_inverse(block, relative_floor) * (block * near_m + pull);
}

QuadraticForm::Reduced QuadraticForm::reduced(const Eigen::Matrix3d& rotation) const {
  const Vector9d r = entries(rotation);
  const Vector9d half_gradient = reduced_quadratic_ * r + reduced_linear_;
  Eigen::Matrix<double, 9, 3> tangent;
  for (int axis = 0; axis < 3; ++axis) tangent.col(axis) = entries(skew(Eigen::Vector3d::Unit(axis)) * rotation);
  Reduced out;
  out.value = r.dot(half_gradient + reduced_linear_) + reduced_constant_;
  out.gradient = 2.0 * tangent.transpose() * half_gradient;
  out.curvature = 2.0 * tangent.transpose() * reduced_quadratic_ * tangent;
  return out;
}

}  // namespace remount
