#include "algorithms/calibration/robust_start.h"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

#include "algorithms/calibration/pair_equation.h"
#include "algorithms/calibration/pairwise.h"

namespace remount {
namespace {

constexpr double kMedianChi2 = 5.348;  // of six degrees of freedom
constexpr double kKernel2 = 16.0;      // squared distance at which a pair's weight has fallen to a quarter

std::vector<double> distances2(const std::vector<Pair>& pairs, const std::vector<int>& usable, const RigidTransform& x,
                               const NoiseModel& noise) {
  std::vector<double> out;
  out.reserve(usable.size());
  for (const int i : usable) out.push_back(pair_distance2(pairs[static_cast<std::size_t>(i)], x, noise));
  return out;
}

double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

// Least truncated squares: the size of the better half of the residuals, robust up to half outliers.
double better_half(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  double sum = 0.0;
  const std::size_t half = values.size() / 2 + 1;
  for (std::size_t i = 0; i < std::min(half, values.size()); ++i) sum += values[i];
  return sum;
}

std::vector<double> kernel_weights(const std::vector<double>& d2, double scale2) {
  std::vector<double> weights;
  for (const double value : d2) {
    const double ratio = 1.0 + value / (scale2 * kKernel2);
    weights.push_back(1.0 / (ratio * ratio));
  }
  return weights;
}

std::vector<MotionPair> weighted_pairs(const std::vector<Pair>& pairs, const std::vector<int>& usable,
                                       const std::vector<double>& weights) {
  std::vector<MotionPair> out;
  for (std::size_t k = 0; k < usable.size(); ++k) {
    const Pair& pair = pairs[static_cast<std::size_t>(usable[k])];
    out.push_back({pair.ins_b_from_ins_a, pair.lidar_b_from_lidar_a, weights[k]});
  }
  return out;
}

// Turns X about the axis that the pairs do not determine, as close to the reference as that allows.
RigidTransform settled(const RigidTransform& x, const QuadraticForm& form, const RotationReference& reference,
                       const Eigen::Vector3d& near_m) {
  constexpr double kUndetermined = 1e-3;  // of the largest curvature: noise of attitude is a thousand times below turns
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> eigen(form.reduced(x.linear()).curvature);
  if (eigen.eigenvalues()[0] > kUndetermined * eigen.eigenvalues()[2]) return x;
  const Eigen::Vector3d axis = eigen.eigenvectors().col(0);
  // The best turn about an axis maximises the trace of reference' Exp(angle axis) R: a sine and a cosine term.
  Eigen::Matrix3d correlation;
  if (reference.ins_from_lidar)
    correlation = x.linear() * reference.ins_from_lidar->transpose();
  else if (reference.up_in_lidar)
    correlation = x.linear() * *reference.up_in_lidar * Eigen::Vector3d::UnitZ().transpose();
  else
    return x;
  const double cosine = correlation.trace() - axis.dot(correlation * axis);
  const double sine = (skew(axis) * correlation).trace();
  const Eigen::Matrix3d rotation = so3_exp(std::atan2(sine, cosine) * axis) * x.linear();
  return make_rigid(rotation, form.best_translation_m(rotation, near_m, 1e-4));
}

// One reweighted Gauss-Newton step on X alone.
RigidTransform weighted_step(const std::vector<Pair>& pairs, const std::vector<int>& usable,
                             const std::vector<double>& weights, const NoiseModel& noise, const RigidTransform& x) {
  Matrix6d hessian = Matrix6d::Zero();
  Vector6d side = Vector6d::Zero();
  for (std::size_t k = 0; k < usable.size(); ++k) {
    const Pair& pair = pairs[static_cast<std::size_t>(usable[k])];
    const PairEquation equation = linearise_pair(pair.ins_b_from_ins_a, pair.lidar_b_from_lidar_a, x);
    const Matrix6d information = weights[k] * noise.registration_information(pair.registration.information);
    hessian += equation.d_x.transpose() * information * equation.d_x;
    side -= equation.d_x.transpose() * information * equation.residual;
  }
  // Only along directions that stand out of the noise: a metre of translation weighs like 0.1 rad of rotation.
  constexpr double kUndetermined = 3e-4;
  Vector6d scale;
  scale << Eigen::Vector3d::Ones(), Eigen::Vector3d::Constant(0.1);
  const Eigen::SelfAdjointEigenSolver<Matrix6d> eigen(scale.asDiagonal() * hessian * scale.asDiagonal());
  Vector6d step = Vector6d::Zero();
  for (int i = 0; i < 6; ++i) {
    const double value = eigen.eigenvalues()[i];
    if (value > kUndetermined * eigen.eigenvalues()[5])
      step += eigen.eigenvectors().col(i) * (eigen.eigenvectors().col(i).dot(scale.cwiseProduct(side)) / value);
  }
  return perturbed(x, scale.cwiseProduct(step));
}

}  // namespace

RobustStart robust_start(const std::vector<Pair>& pairs, const std::vector<int>& usable, const NoiseModel& noise,
                         const std::optional<RigidTransform>& nominal, const RotationReference& reference,
                         const Eigen::Vector3d& near_m) {
  RobustStart start;
  double least = std::numeric_limits<double>::infinity();
  const auto consider = [&](const RigidTransform& x) {
    const double cost = better_half(distances2(pairs, usable, x, noise));
    if (!(cost < least)) return;
    least = cost;
    start.ins_from_lidar = x;
  };
  if (nominal) consider(*nominal);
  std::vector<double> weights;
  for (const int i : usable) weights.push_back(pairs[static_cast<std::size_t>(i)].screw.passed ? 1.0 : 0.0);
  if (std::count(weights.begin(), weights.end(), 1.0) < 3) std::fill(weights.begin(), weights.end(), 1.0);
  for (int round = 0; round < 6; ++round) {
    const QuadraticForm form(weighted_pairs(pairs, usable, weights), 10.0);
    const RigidTransform x = settled(joint_quadratic(form, near_m), form, reference, near_m);
    consider(x);
    const std::vector<double> d2 = distances2(pairs, usable, x, noise);
    weights = kernel_weights(d2, std::max(1.0, median(d2) / kMedianChi2));
  }
  for (int iteration = 0; iteration < 20; ++iteration) {
    const std::vector<double> d2 = distances2(pairs, usable, start.ins_from_lidar, noise);
    const double scale2 = std::max(1.0, median(d2) / kMedianChi2);
    const RigidTransform next = weighted_step(pairs, usable, kernel_weights(d2, scale2), noise, start.ins_from_lidar);
    const Vector6d step = difference(start.ins_from_lidar, next);
    if (!step.allFinite()) break;
    start.ins_from_lidar = next;
    start.noise_scale = std::sqrt(scale2);
    if (step.head<3>().norm() < 1e-6 && step.tail<3>().norm() < 1e-7) break;
  }
  return start;
}

}  // namespace remount
