#include "algorithms/calibration/robust_start.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

#include "algorithms/calibration/pair_equation.h"
#include "algorithms/calibration/pair_judgement.h"
#include "algorithms/core/symmetric_eigen.h"

namespace remount {
namespace {

constexpr double kKernel2 = 16.0;  // squared distance at which a pair's weight has fallen to a quarter

// Every pair counts, the wrong ones all alike: a few pairs that agree by chance, or that any X satisfies, do not win.
double truncated_cost(const std::vector<double>& values, double scale2) {
  double sum = 0.0;
  for (const double value : values) sum += std::min(value, kKernel2 * scale2);
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

std::vector<MotionPair> weighted_pairs(const std::vector<NoisyPair>& pairs, const std::vector<double>& weights) {
  std::vector<MotionPair> out;
  out.reserve(pairs.size());
  for (std::size_t k = 0; k < pairs.size(); ++k)
    out.push_back({pairs[k].ins_b_from_ins_a, pairs[k].lidar_b_from_lidar_a, weights[k]});
  return out;
}

// Turns X about the axis that the pairs do not determine, as close to the reference as that allows.
RigidTransform settled(const RigidTransform& x, const QuadraticForm& form, const RotationReference& reference,
                       const Eigen::Vector3d& near_m) {
  constexpr double kUndetermined = 1e-3;  // of the largest curvature: noise of attitude is a thousand times below turns
  const auto eigen = symmetric_eigen(Eigen::Matrix3d(form.reduced(x.linear()).curvature));
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
RigidTransform weighted_step(const std::vector<NoisyPair>& pairs, const std::vector<double>& weights,
                             const RigidTransform& x) {
  Matrix6d hessian = Matrix6d::Zero();
  Vector6d side = Vector6d::Zero();
  for (std::size_t k = 0; k < pairs.size(); ++k) {
    const NoisyPair& pair = pairs[k];
    const MountingEquation equation = linearise_in_mounting(pair.ins_b_from_ins_a, pair.lidar_b_from_lidar_a, x);
    const Matrix6d weighted = weights[k] * equation.d_x.transpose() * pair.registration_information;
    hessian.noalias() += weighted * equation.d_x;
    side.noalias() -= weighted * equation.residual;
  }
  // Only along directions that stand out of the noise: a metre of translation weighs like 0.1 rad of rotation.
  constexpr double kUndetermined = 3e-4;
  Vector6d scale;
  scale << Eigen::Vector3d::Ones(), Eigen::Vector3d::Constant(0.1);
  const auto eigen = symmetric_eigen(Matrix6d(scale.asDiagonal() * hessian * scale.asDiagonal()));
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
                         const Eigen::Vector3d& near_m, const Progress& progress, const PairTilts& tilts_rad) {
  RobustStart start;
  const std::vector<NoisyPair> noisy = noisy_pairs(pairs, usable, noise, tilts_rad);
  std::vector<RigidTransform> tried;
  std::vector<std::vector<double>> tried_d2;
  const auto consider = [&](const RigidTransform& x) {
    tried.push_back(x);
    tried_d2.push_back(distances2(noisy, x));
    ++start.passes;
  };
  if (nominal) consider(*nominal);
  std::vector<double> weights;
  for (const int i : usable) weights.push_back(pairs[static_cast<std::size_t>(i)].screw.passed ? 1.0 : 0.0);
  if (std::count(weights.begin(), weights.end(), 1.0) < 3) std::fill(weights.begin(), weights.end(), 1.0);
  for (int round = 0; round < 8 && !progress.cancelled(); ++round) {
    const QuadraticForm form(weighted_pairs(noisy, weights), 10.0);
    consider(settled(joint_quadratic(form, near_m), form, reference, near_m));
    weights = kernel_weights(tried_d2.back(), residual_scale2(tried_d2.back()));
  }
  double scale2 = std::numeric_limits<double>::infinity(), least = scale2;
  for (const std::vector<double>& d2 : tried_d2) scale2 = std::min(scale2, residual_scale2(d2));
  for (std::size_t i = 0; i < tried.size(); ++i) {
    const double cost = truncated_cost(tried_d2[i], scale2);
    if (cost < least) start.ins_from_lidar = tried[i];
    least = std::min(least, cost);
  }
  for (int iteration = 0; iteration < 20 && !progress.cancelled(); ++iteration) {
    const std::vector<double> d2 = distances2(noisy, start.ins_from_lidar);
    scale2 = residual_scale2(d2);
    const RigidTransform next = weighted_step(noisy, kernel_weights(d2, scale2), start.ins_from_lidar);
    ++start.passes;
    const Vector6d step = difference(start.ins_from_lidar, next);
    if (!step.allFinite()) break;
    start.ins_from_lidar = next;
    start.noise_scale = std::sqrt(scale2);
    if (step.head<3>().norm() < 1e-6 && step.tail<3>().norm() < 1e-7) break;
  }
  return start;
}

}  // namespace remount
