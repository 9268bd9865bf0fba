#include "algorithms/calibration/joint/rotation_equation.h"

#include <algorithm>
#include <cmath>

#include "algorithms/core/decompositions.h"
#include "algorithms/core/index.h"
#include "algorithms/core/median.h"
#include "algorithms/core/symmetric_eigen.h"
#include "messages/calibration.h"

namespace remount::calibration {
namespace {

using Eigen::Matrix3d;
using Eigen::Matrix4d;
using Eigen::Vector3d;
using Eigen::Vector4d;

Vector4d quaternion_of(const Matrix3d& rotation) {  // w, x, y, z with w >= 0
  const Eigen::Quaterniond q(rotation);
  const Vector4d wxyz(q.w(), q.x(), q.y(), q.z());
  return q.w() < 0.0 ? Vector4d(-wxyz) : wxyz;
}

// [q]_L p = q p.
Matrix4d left_product(const Vector4d& q) {
  Matrix4d m;
  m << q[0], -q[1], -q[2], -q[3], q[1], q[0], -q[3], q[2], q[2], q[3], q[0], -q[1], q[3], -q[2], q[1], q[0];
  return m;
}

// [q]_R p = p q.
Matrix4d right_product(const Vector4d& q) {
  Matrix4d m;
  m << q[0], -q[1], -q[2], -q[3], q[1], q[0], q[3], -q[2], q[2], -q[3], q[0], q[1], q[3], q[2], -q[1], q[0];
  return m;
}

Message axis_words(const Vector3d& axis) {
  int largest = 0;
  axis.cwiseAbs().maxCoeff(&largest);
  if (std::abs(axis[largest]) < 0.9) return say::axis_slanted();
  return largest == 2 ? say::axis_vertical() : largest == 1 ? say::axis_transverse() : say::axis_long();
}

void describe(const std::vector<TurnPair>& turns, const std::vector<double>& weights, double noise_rad,
              RotationEquationResult& result) {
  Matrix3d scatter = Matrix3d::Zero(), information = Matrix3d::Zero();
  double total = 0.0;
  for (std::size_t i = 0; i < turns.size(); ++i) {
    const Vector3d phi = so3_log(turns[i].in_a);
    scatter += weights[i] * phi * phi.transpose();
    information += weights[i] * (phi.squaredNorm() * Matrix3d::Identity() - phi * phi.transpose());
    total += weights[i];
  }
  const auto eigen = symmetric_eigen(Matrix3d(scatter / total));
  result.main_axis_in_a = eigen.eigenvectors().col(2);
  if (result.main_axis_in_a.z() < 0.0) result.main_axis_in_a = -result.main_axis_in_a;
  result.main_axis_turn_rad = std::sqrt(std::max(0.0, eigen.eigenvalues()[2]));
  result.other_axes_turn_rad = std::sqrt(std::max(0.0, eigen.eigenvalues()[0] + eigen.eigenvalues()[1]));
  const double noise = std::max(noise_rad, result.residual_rad);
  result.solved = result.main_axis_turn_rad > 3.0 * noise;
  // Noise alone shows as turns about the other axes of its own size: more than that must be there.
  result.rotation_about_main_axis_observed = result.solved && result.other_axes_turn_rad > 3.0 * noise;
  const auto observed = symmetric_eigen(information);
  for (int i = 0; i < 3; ++i) {
    const Vector3d v = observed.eigenvectors().col(i);
    const bool along_main = std::abs(v.dot(result.main_axis_in_a)) > 0.7;
    if (along_main && !result.rotation_about_main_axis_observed) continue;
    result.covariance_rad2 += v * v.transpose() * noise * noise / std::max(observed.eigenvalues()[i], 1e-300);
  }
  result.words = !result.solved                              ? say::rotation_small_turns()
                 : !result.rotation_about_main_axis_observed ? say::rotation_one_axis(axis_words(result.main_axis_in_a))
                                                             : say::rotation_all_angles({result.other_axes_turn_rad});
}

}  // namespace

RotationEquationResult solve_rotation_equation(const std::vector<TurnPair>& turns, double noise_rad) {
  RotationEquationResult result;
  if (turns.empty()) {
    result.words = say::rotation_no_turn();
    return result;
  }
  std::vector<double> weights(turns.size(), 1.0);
  constexpr int kRounds = 6;
  for (int round = 0; round < kRounds; ++round) {
    double total = 0.0;
    for (const double weight : weights) total += weight;
    Eigen::MatrixXd stacked(static_cast<Eigen::Index>(4 * turns.size()), 4);
    for (std::size_t i = 0; i < turns.size(); ++i)
      stacked.middleRows<4>(static_cast<Eigen::Index>(4 * i)) =
          std::sqrt(weights[i] / total) *
          (left_product(quaternion_of(turns[i].in_a)) - right_product(quaternion_of(turns[i].in_b)));
    const Eigen::JacobiSVD<Eigen::MatrixXd> svd = singular_values(stacked, Eigen::ComputeThinV);
    for (int k = 0; k < 4; ++k) result.singular_values[index_at(k)] = svd.singularValues()[k];
    const Vector4d q = svd.matrixV().col(3);
    result.a_from_b = Eigen::Quaterniond(q[0], q[1], q[2], q[3]).normalized().toRotationMatrix();
    std::vector<double> misfit;
    for (const TurnPair& turn : turns)
      misfit.push_back(
          so3_log(turn.in_a.transpose() * result.a_from_b * turn.in_b * result.a_from_b.transpose()).norm());
    // 1.54: median of the norm of three normal numbers of unit variance. What is left is the sigma of each axis.
    result.residual_rad = median_of(misfit) / 1.54;
    const double scale = 3.0 * std::max(result.residual_rad, 1e-9);
    for (std::size_t i = 0; i < turns.size(); ++i) weights[i] = 1.0 / (1.0 + std::pow(misfit[i] / scale, 2));
  }
  describe(turns, weights, noise_rad, result);
  return result;
}

PlanarMounting solve_planar_mounting(const std::vector<PlanarMotion>& motions, bool scale_known) {
  PlanarMounting mounting;
  const auto rows = static_cast<Eigen::Index>(2 * motions.size());
  Eigen::MatrixXd left = Eigen::MatrixXd::Zero(rows, 4);  // x, y, scale cos(yaw), scale sin(yaw)
  Eigen::VectorXd right(rows);
  double turned2 = 0.0, travelled2 = 0.0;
  for (std::size_t i = 0; i < motions.size(); ++i) {
    const PlanarMotion& motion = motions[i];
    const auto row = static_cast<Eigen::Index>(2 * i);
    const double c = std::cos(motion.turn_rad), s = std::sin(motion.turn_rad);
    const Eigen::Vector2d t = motion.sensor_travel;
    left.block<2, 2>(row, 0) << c - 1.0, -s, s, c - 1.0;
    left.block<2, 2>(row, 2) << -t.x(), t.y(), -t.y(), -t.x();
    right.segment<2>(row) = -motion.travel_m;
    turned2 += motion.turn_rad * motion.turn_rad;
    travelled2 += t.squaredNorm();
  }
  if (motions.empty() || travelled2 <= 0.0) return mounting;
  mounting.solved = true;
  constexpr double kLeastTurn_rad = 0.02;  // root mean square of an interval: below it x and y are noise
  mounting.position_observed = turned2 > kLeastTurn_rad * kLeastTurn_rad * static_cast<double>(motions.size());
  if (!mounting.position_observed) left.leftCols<2>().setZero();
  const Eigen::Vector4d solution = least_norm_solution(left, right);
  mounting.yaw_rad = std::atan2(solution[3], solution[2]);
  mounting.scale = scale_known ? 1.0 : solution.tail<2>().norm();
  if (!mounting.position_observed) return mounting;
  const Eigen::Vector2d turned(mounting.scale * std::cos(mounting.yaw_rad),
                               mounting.scale * std::sin(mounting.yaw_rad));
  const Eigen::Vector2d position = least_norm_solution(left.leftCols<2>(), right - left.rightCols<2>() * turned);
  mounting.x_m = position.x();
  mounting.y_m = position.y();
  return mounting;
}

}  // namespace remount::calibration
