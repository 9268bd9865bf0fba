#include "algorithms/calibration/joint/joint_solver.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

#include "algorithms/calibration/joint/joint_equations.h"
#include "algorithms/calibration/linear_solutions.h"

namespace remount::calibration {
namespace {

void take_step(const Eliminated& step, double share, const Layout& layout, State& state) {
  for (motion::LidarIndex l; l < state.ins_from_lidars.size(); ++l)
    state.ins_from_lidars[l] =
        perturb(state.ins_from_lidars[l], share * step.shared_step.segment<6>(layout.mounting_at(l)));
  const Eigen::Index others = state.shared.size() - layout.mountings_size();
  state.shared.tail(others) += share * step.shared_step.tail(others);
  for (motion::KeyframeIndex k; k < state.errors.size(); ++k) {
    state.errors[k] += share * step.keyframe_step.segment<6>(layout.node_at(k));
    if (layout.drift) state.drifts[k] += share * step.keyframe_step.segment<6>(layout.drift_at(k));
  }
}

// Whether a step goes back by more than half of the one before: along a height that hardly shows, whole steps may go to
// and fro for ever. @param weighted the step times its information
bool returns(const Eigen::VectorXd& before, const Eigen::VectorXd& weighted, double squared_sigmas) {
  return before.size() > 0 && -before.dot(weighted) > 0.5 * squared_sigmas && squared_sigmas > 1.0;
}

void describe(const JointProblem& problem, const Layout& layout, const State& state, const Eliminated& last,
              JointSolution& solution) {
  const RigidTransform& x = state.ins_from_lidars.front();
  solution.ins_from_lidar = x;
  solution.ins_from_lidar.linear() = nearest_rotation(x.linear());
  const Eigen::MatrixXd covariance =
      symmetric_solution(last.reduced, Eigen::MatrixXd::Identity(layout.size(), layout.size()));
  solution.covariance = covariance.topLeftCorner<6, 6>();
  solution.last_step = last.shared_step.head<6>();
  // Marginal information of X from the pairs alone: the Schur complement over the sessions' unknowns, without the prior
  // and what was measured.
  Eigen::MatrixXd without_prior = last.reduced;
  without_prior.topLeftCorner<6, 6>() -= problem.lidar().prior_information + problem.lidar().measured.information(x);
  const Eigen::Index rest = layout.size() - 6;
  solution.information = without_prior.topLeftCorner<6, 6>();
  if (rest > 0)
    solution.information -= without_prior.topRightCorner(6, rest) *
                            symmetric_solution(Eigen::MatrixXd(without_prior.bottomRightCorner(rest, rest)),
                                               without_prior.bottomLeftCorner(rest, 6));
  solution.node_errors = state.errors;
  solution.minus_two_log_likelihood = last.minus_two_log_likelihood;
  for (motion::SessionIndex s; signed_of(s) < layout.sessions; ++s) {
    if (layout.bias) solution.attitude_bias_rad.push_back(state.shared.segment<3>(layout.bias_at(s)));
    const auto tell = [&](Eigen::Index at, std::vector<double>& values, std::vector<double>& sigmas) {
      values.push_back(state.shared[at]);
      sigmas.push_back(std::sqrt(std::max(0.0, covariance(at, at))));
    };
    if (layout.clock) tell(layout.clock_at(s), solution.time_offset_s, solution.time_offset_sigma_s);
    if (!layout.lag) continue;
    const Eigen::Index at = layout.lag_at(s);
    tell(at, solution.position_lag_s, solution.position_lag_sigma_s);
    solution.moved_by_position_lag.push_back(covariance.block<6, 1>(0, at) / covariance(at, at));
  }
  solution.beams = state.shared.segment(layout.beams_at(), layout.beams);
  solution.beams_covariance = covariance.block(layout.beams_at(), layout.beams_at(), layout.beams, layout.beams);
}

}  // namespace

bool solve_by_gauss_newton(const JointProblem& problem, const NoiseModel& noise, const Layout& layout,
                           int max_iterations, const Progress& progress, State& state, Eliminated& step) {
  bool converged = false;
  double share = 1.0;
  Eigen::VectorXd before;  // the step before
  for (int iteration = 0; iteration < max_iterations && !progress.cancelled(); ++iteration) {
    eliminate(build(problem, linearise(problem, state, layout), noise, state, layout), step);
    if (!step.valid) return false;
    const Eigen::VectorXd weighted = step.reduced * step.shared_step;
    // In units of sigma: a direction that the data hardly show needs no more digits than it has.
    const double squared_sigmas = step.shared_step.dot(weighted);
    share = returns(before, weighted, squared_sigmas) ? 0.5 * share : std::min(1.0, 2.0 * share);
    take_step(step, share, layout, state);
    converged = squared_sigmas < 1e-3;
    if (squared_sigmas < 1e-8) break;
    before = step.shared_step;
  }
  return converged && !progress.cancelled();
}

JointSolution solve_joint(const JointProblem& problem, const NoiseModel& noise, const RigidTransform& start,
                          int max_iterations, const Progress& progress) {
  const Layout layout = layout_of(problem, noise);
  State state = start_state(problem, layout, {start});
  JointSolution solution;
  solution.ins_from_lidar = start;
  Eliminated step;
  solution.converged = solve_by_gauss_newton(problem, noise, layout, max_iterations, progress, state, step);
  if (step.valid) describe(problem, layout, state, step, solution);
  return solution;
}

}  // namespace remount::calibration
