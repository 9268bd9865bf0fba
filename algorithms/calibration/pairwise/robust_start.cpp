#include "algorithms/calibration/pairwise/robust_start.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

#include "algorithms/calibration/joint/pair_equation.h"
#include "algorithms/calibration/linear_solutions.h"
#include "algorithms/calibration/observability.h"
#include "algorithms/calibration/pairwise/pair_judgement.h"
#include "algorithms/core/symmetric_eigen.h"

namespace remount::calibration {
namespace {

constexpr double kKernel2 = 16.0;  // squared distance at which a pair's weight has fallen to a quarter

// Every pair counts, the wrong ones all alike: a few pairs that agree by chance, or that any X satisfies, do not win.
// docs/maths/pairwise.md (P6)
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

std::vector<search::MotionPair> weighted_pairs(const std::vector<NoisyPair>& pairs,
                                               const std::vector<double>& weights) {
  std::vector<search::MotionPair> out;
  out.reserve(pairs.size());
  for (std::size_t k = 0; k < pairs.size(); ++k)
    out.push_back({pairs[k].ins_b_from_ins_a, pairs[k].lidar_b_from_lidar_a, weights[k]});
  return out;
}

// X turned about the axis that the pairs determine least, as close to the reference as that allows.
RigidTransform settle_rotation(const RigidTransform& x, const search::QuadraticForm& form,
                               const RotationReference& reference, const Eigen::Vector3d& near_m) {
  const auto eigen = symmetric_eigen(Eigen::Matrix3d(form.reduced(x.linear()).curvature));
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

// An X and how it does: its cost counts `allowance` times.
struct Trial {
  RigidTransform ins_from_lidar = RigidTransform::Identity();
  std::vector<double> d2;
  double allowance = 1.0;
};

// Of those from `first` on, with all compared at the scale of the smallest residuals.
const Trial& best_of(const std::vector<Trial>& tried, std::size_t first) {
  double scale2 = std::numeric_limits<double>::infinity();
  for (std::size_t i = first; i < tried.size(); ++i) scale2 = std::min(scale2, residual_scale2(tried[i].d2));
  std::size_t best = first;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = first; i < tried.size(); ++i) {
    const double cost = tried[i].allowance * truncated_cost(tried[i].d2, scale2);
    if (cost < least) best = i;
    least = std::min(least, cost);
  }
  return tried[best];
}

// One reweighted Gauss-Newton step on X alone, held near `likely` by the weak prior. Many pairs overlap or were chained
// and err alike: what a straight road does not show would follow them far away, if the prior did not count as a
// tenth of them. A few lie apart, and need it only where they show nothing at all. docs/maths/pairwise.md (P19)
RigidTransform weighted_step(const std::vector<NoisyPair>& pairs, const std::vector<double>& weights, double scale2,
                             const RigidTransform& likely, const Matrix6d& prior, const RigidTransform& x) {
  constexpr double kErrAlike = 10.0, kApart = 30.0, kLeast = 1e-6;
  const auto count = static_cast<double>(pairs.size());
  const Matrix6d held = scale2 * std::max(kLeast * count, (count - kApart) / kErrAlike) * prior;
  Matrix6d hessian = held;
  Vector6d side = held * difference(x, likely);
  for (std::size_t k = 0; k < pairs.size(); ++k) {
    const NoisyPair& pair = pairs[k];
    const MountingEquation equation = linearise_in_mounting(pair.ins_b_from_ins_a, pair.lidar_b_from_lidar_a, x);
    const Matrix6d weighted = weights[k] * equation.d_x.transpose() * pair.registration_information;
    hessian.noalias() += weighted * equation.d_x;
    side.noalias() -= weighted * equation.residual;
  }
  return perturb(x, symmetric_solution(hessian, side));
}

}  // namespace

RobustStart robust_start(const std::vector<motion::Pair>& pairs, const std::vector<motion::PairIndex>& usable,
                         const NoiseModel& noise, const std::optional<RigidTransform>& nominal,
                         const RotationReference& reference, const Eigen::Vector3d& near_m, const Progress& progress,
                         const PairTilts& tilts_rad) {
  RobustStart start;
  const std::vector<NoisyPair> noisy = noisy_pairs(pairs, usable, noise, tilts_rad);
  std::vector<Trial> tried;
  const auto consider = [&](const RigidTransform& x, double allowance) {
    tried.push_back({x, distances2(noisy, x), allowance});
    ++start.passes;
  };
  if (nominal) consider(*nominal, 1.0);
  std::vector<double> weights;
  for (const motion::PairIndex i : usable) weights.push_back(pairs[i].screw.passed ? 1.0 : 0.0);
  if (std::count(weights.begin(), weights.end(), 1.0) < 3) std::fill(weights.begin(), weights.end(), 1.0);
  for (int round = 0; round < 8 && !progress.cancelled(); ++round) {
    const search::QuadraticForm form(weighted_pairs(noisy, weights), 10.0);
    const std::size_t first = tried.size();
    const RigidTransform x = search::joint_quadratic(form, near_m);
    consider(x, 1.0);
    if (reference.ins_from_lidar || reference.up_in_lidar)
      consider(settle_rotation(x, form, reference, near_m), reference.allowance);
    const std::vector<double>& d2 = best_of(tried, first).d2;
    weights = kernel_weights(d2, residual_scale2(d2));
  }
  if (!tried.empty()) start.ins_from_lidar = best_of(tried, 0).ins_from_lidar;
  double scale2 = std::numeric_limits<double>::infinity();
  const RigidTransform likely = make_rigid(start.ins_from_lidar.linear(), near_m);
  const Matrix6d prior = weak_prior(nominal.has_value());
  for (int iteration = 0; iteration < 20 && !progress.cancelled(); ++iteration) {
    const std::vector<double> d2 = distances2(noisy, start.ins_from_lidar);
    scale2 = residual_scale2(d2);
    const RigidTransform next =
        weighted_step(noisy, kernel_weights(d2, scale2), scale2, likely, prior, start.ins_from_lidar);
    ++start.passes;
    const Vector6d step = difference(start.ins_from_lidar, next);
    if (!step.allFinite()) break;
    start.ins_from_lidar = next;
    start.noise_scale = std::sqrt(scale2);
    if (step.head<3>().norm() < 1e-6 && step.tail<3>().norm() < 1e-7) break;
  }
  return start;
}

}  // namespace remount::calibration
