#include "algorithms/calibration/joint/shared_errors.h"

#include <Eigen/Cholesky>
#include <cmath>

#include "algorithms/calibration/joint/joint_equations.h"
#include "algorithms/calibration/linear_solutions.h"
#include "algorithms/core/symmetric_eigen.h"

namespace remount::calibration {
namespace {

// The usual size, and how far drives differ from it (docs/adr/0006-honest-sigma.md).
constexpr double kUsual_m = 1.2e-4, kUsual_rad = 1.8e-5, kLogSpread = 0.7;

using Shapes = Eigen::Matrix<double, 6, 12>;
using Matrix12d = Eigen::Matrix<double, 12, 12>;
using Vector12d = Eigen::Matrix<double, 12, 1>;

// What the errors do to a registered motion that is so long, as a share of the longest.
Shapes shapes_at(double share) {
  Vector6d sigmas;
  sigmas << Eigen::Vector3d::Constant(kUsual_m), Eigen::Vector3d::Constant(kUsual_rad);
  Shapes shapes;
  shapes << Matrix6d((1.0 - share) * sigmas.asDiagonal()), Matrix6d(share * sigmas.asDiagonal());
  return shapes;
}

// Their part of the normal equations: against the keyframes, against X and what is shared, and on their own.
struct Part {
  Eigen::MatrixXd keyframes, shared;
  Matrix12d own = Matrix12d::Zero();
  Vector12d side = Vector12d::Zero();
};

Part build_part(const std::vector<LinearTerm>& terms, const NoiseModel& noise, const NormalEquations& equations) {
  double longest_m = 1e-9;
  for (const LinearTerm& term : terms)
    longest_m = std::max(longest_m, term.term->lidar_b_from_lidar_a.translation().norm());
  Part part{Eigen::MatrixXd::Zero(equations.coupling.rows(), 12), Eigen::MatrixXd::Zero(equations.shared.rows(), 12)};
  for (const LinearTerm& term : terms) {
    const Shapes shapes = shapes_at(term.term->lidar_b_from_lidar_a.translation().norm() / longest_m);
    const Shapes weighted = term_information(term, noise) * shapes;
    for (const NodePart* node : {&term.a, &term.b})
      part.keyframes.middleRows(node->at, node->jacobian.cols()).noalias() += node->jacobian.transpose() * weighted;
    part.shared.noalias() += term.shared.transpose() * weighted;
    part.own.noalias() += shapes.transpose() * weighted;
    part.side.noalias() -= weighted.transpose() * term.residual;
  }
  return part;
}

// Restricted maximum likelihood of the size, from the errors' information once everything else has moved along, and
// their gradient. docs/maths/covariance.md (C20)
double likely_size(const Matrix12d& information, const Vector12d& gradient) {
  const auto eigen = symmetric_eigen(Eigen::MatrixXd(information));
  const Vector12d pulls = eigen.eigenvectors().transpose() * gradient;
  const auto cost = [&](double log_size) {
    double sum = log_size * log_size / (kLogSpread * kLogSpread);
    for (int i = 0; i < 12; ++i) {
      const double known = eigen.eigenvalues()[i];
      if (!(known > 1e-9 * eigen.eigenvalues()[11])) continue;
      const double variance = 1.0 + std::exp(2.0 * log_size) * known;  // of the pull, over what noise alone would do
      sum += std::log(variance) + pulls[i] * pulls[i] / (known * variance);
    }
    return sum;
  };
  constexpr double kLeast = -3.0, kMost = 3.0, kStep = 0.05;
  double best = 0.0;
  for (double log_size = kLeast; log_size <= kMost; log_size += kStep)
    if (cost(log_size) < cost(best)) best = log_size;
  return std::exp(best);
}

}  // namespace

SharedErrors shared_errors(const JointProblem& problem, const NoiseModel& noise, const JointSolution& solution) {
  if (problem.terms.empty()) return {};
  const Layout layout = layout_of(problem, noise);
  const State state = start_state(problem, layout, {solution.ins_from_lidar});
  const std::vector<LinearTerm> terms = linearise(problem, state, layout);
  const NormalEquations equations = build(problem, terms, noise, state, layout);
  Eliminated others;
  eliminate(equations, others);
  if (!others.valid) return {};
  const Part part = build_part(terms, noise, equations);
  const Eigen::MatrixXd along_keyframes = others.factors.solve(part.keyframes);
  const Eigen::MatrixXd shared = part.shared - equations.coupling.transpose() * along_keyframes;
  const Eigen::MatrixXd moved = symmetric_solution(others.whole, shared);
  const Matrix12d information = part.own - part.keyframes.transpose() * along_keyframes - shared.transpose() * moved;
  const Vector12d gradient = part.side - part.keyframes.transpose() * others.whole_keyframe_step -
                             part.shared.transpose() * others.whole_shared_step;
  SharedErrors out;
  out.size = likely_size(information, gradient);
  out.responses = out.size * symmetric_solution(others.reduced, others.counted * shared).topRows<6>();
  return out;
}

}  // namespace remount::calibration
