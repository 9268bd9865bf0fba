#include "algorithms/calibration/joint/joint_solver.h"

#include <Eigen/Cholesky>
#include <cmath>

#include "algorithms/calibration/joint/joint_equations.h"

namespace remount::calibration {
namespace {

void take_step(const Eliminated& step, const Layout& layout, State& state) {
  state.ins_from_lidar = perturbed(state.ins_from_lidar, step.shared_step.head<6>());
  state.shared.tail(state.shared.size() - 6) += step.shared_step.tail(state.shared.size() - 6);
  for (motion::KeyframeIndex k; k < state.errors.size(); ++k) {
    state.errors[k] += step.keyframe_step.segment<6>(layout.node_at(k));
    if (layout.drift) state.drifts[k] += step.keyframe_step.segment<6>(layout.node_at(k) + 6);
  }
}

void describe(const JointProblem& problem, const Layout& layout, const State& state, const Eliminated& last,
              JointSolution& solution) {
  solution.ins_from_lidar = state.ins_from_lidar;
  solution.ins_from_lidar.linear() = nearest_rotation(state.ins_from_lidar.linear());
  const Eigen::MatrixXd covariance = last.reduced.ldlt().solve(Eigen::MatrixXd::Identity(layout.size(), layout.size()));
  solution.covariance = covariance.topLeftCorner<6, 6>();
  solution.last_step = last.shared_step.head<6>();
  // Marginal information of X from the pairs alone: the Schur complement over the sessions' unknowns, without the prior
  // and what was measured.
  Eigen::MatrixXd without_prior = last.reduced;
  without_prior.topLeftCorner<6, 6>() -= problem.prior_information + problem.measured.information(state.ins_from_lidar);
  const Eigen::Index rest = layout.size() - 6;
  solution.information = without_prior.topLeftCorner<6, 6>();
  if (rest > 0)
    solution.information -=
        without_prior.topRightCorner(6, rest) *
        without_prior.bottomRightCorner(rest, rest).ldlt().solve(without_prior.bottomLeftCorner(rest, 6));
  solution.node_errors = state.errors;
  for (std::size_t k = 0; layout.drift && k < state.drifts.size(); ++k)
    solution.node_errors[k] += drift_in_body(problem.nodes[k]) * state.drifts[k];
  solution.minus_two_log_likelihood = last.minus_two_log_likelihood;
  for (motion::SessionIndex s; signed_of(s) < layout.sessions; ++s) {
    if (layout.bias) solution.attitude_bias_rad.push_back(state.shared.segment<3>(layout.bias_at(s)));
    const auto tell = [&](Eigen::Index at, std::vector<double>& values, std::vector<double>& sigmas) {
      values.push_back(state.shared[at]);
      sigmas.push_back(std::sqrt(std::max(0.0, covariance(at, at))));
    };
    if (layout.clock) tell(layout.clock_at(s), solution.time_offset_s, solution.time_offset_sigma_s);
    if (layout.lag) tell(layout.lag_at(s), solution.position_lag_s, solution.position_lag_sigma_s);
  }
}

// Gauss-Newton; true where it converged. `step` is the last one taken, invalid where a linearisation was singular.
bool iterate(const JointProblem& problem, const NoiseModel& noise, const Layout& layout, int max_iterations,
             const Progress& progress, State& state, Eliminated& step) {
  bool converged = false;
  for (int iteration = 0; iteration < max_iterations && !progress.cancelled(); ++iteration) {
    eliminate(build(problem, linearise(problem, state, layout), noise, state, layout), step);
    if (!step.valid) return false;
    take_step(step, layout, state);
    // In units of sigma: a direction that the data hardly show needs no more digits than it has.
    const double squared_sigmas = step.shared_step.dot(step.reduced * step.shared_step);
    converged = squared_sigmas < 1e-3;
    if (squared_sigmas < 1e-8) break;
  }
  return converged && !progress.cancelled();
}

}  // namespace

JointSolution solve_joint(const JointProblem& problem, const NoiseModel& noise, const RigidTransform& start,
                          int max_iterations, const Progress& progress) {
  const Layout layout = layout_of(problem, noise);
  State state = start_state(problem, layout, start);
  JointSolution solution;
  solution.ins_from_lidar = start;
  Eliminated step;
  solution.converged = iterate(problem, noise, layout, max_iterations, progress, state, step);
  if (step.valid) describe(problem, layout, state, step, solution);
  return solution;
}

std::vector<MeasurementPull> measurement_pulls(const JointProblem& problem, const NoiseModel& noise,
                                               const JointSolution& solution, const Progress& progress) {
  constexpr int kIterations = 8;
  const Layout layout = layout_of(problem, noise);
  State state = start_state(problem, layout, solution.ins_from_lidar);
  Eliminated step;
  iterate(problem, noise, layout, kIterations, progress, state,
          step);  // to where it can be, see settles_where_observed
  if (!step.valid || progress.cancelled()) return {};
  const std::vector<LinearTerm> terms = linearise(problem, state, layout);
  const NormalEquations equations = build(problem, terms, noise, state, layout);
  eliminate(equations, step);
  if (!step.valid) return {};
  // How X moves with the gradient of a shared unknown (columns) and of one of a keyframe's (rows).
  const Eigen::MatrixXd of_shared =
      step.reduced.ldlt().solve(Eigen::MatrixXd::Identity(layout.size(), layout.size())).topRows<6>();
  const Eigen::MatrixXd of_keyframes = -step.factors.solve(equations.coupling) * of_shared.transpose();
  const auto moved_by = [&](Eigen::Index at, const auto& gradient) -> Vector6d {
    return -of_keyframes.middleRows(at, gradient.size()).transpose() * gradient;
  };
  std::vector<MeasurementPull> pulls;
  for (const LinearTerm& term : terms) {
    const Vector6d weighted = term_information(term, noise) * term.residual;
    Vector6d moved = -of_shared * (term.shared.transpose() * weighted);
    for (const NodePart* part : {&term.a, &term.b})
      moved += moved_by(part->at, Eigen::VectorXd(part->jacobian.transpose() * weighted));
    pulls.push_back({moved, term.term->node_a});
  }
  for (motion::KeyframeIndex k; k < problem.nodes.size(); ++k) {
    const Matrix6d covariance = node_covariance(problem, noise, k);
    Vector6d moved = moved_by(layout.node_at(k), Vector6d(covariance.ldlt().solve(state.errors[k])));
    if (layout.drift && !is_first_of_session(problem, k)) {
      const Vector6d change = state.drifts[k] - state.drifts[k - 1];
      const Vector6d weighted = drift_step_information(problem, noise, k).cwiseProduct(change);
      moved += moved_by(layout.node_at(k) + 6, weighted) -
               moved_by(layout.node_at(motion::KeyframeIndex(k - 1)) + 6, weighted);
    }
    pulls.push_back({moved, k});
  }
  return pulls;
}

}  // namespace remount::calibration
