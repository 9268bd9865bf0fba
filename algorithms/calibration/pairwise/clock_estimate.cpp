#include "algorithms/calibration/pairwise/clock_estimate.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "algorithms/calibration/observability.h"
#include "algorithms/calibration/pairwise/bootstrap.h"
#include "messages/parameters.h"

namespace remount::calibration {
namespace {

// Velocities are of a second: what two keyframes that are nearer tell of the times is told twice.
constexpr double kLeastBlock_s = 2.0;

// Errors of an INS last, and what it swings aside by repeats: blocks of time may scatter more than the solution's
// sigma.
void widen_by_blocks(const PairwiseInput& input, const JointProblem& problem, const PairwiseDetails& details,
                     const Progress& progress, JointSolution& solution) {
  const MeasurementPulls pulls(problem, details.noise, solution, progress);
  const bool with_lags = !solution.position_lag_sigma_s.empty();
  for (motion::SessionIndex s; s < solution.time_offset_sigma_s.size(); ++s) {
    const Eigen::MatrixXd scatter =
        bootstrap_covariance(blocks_of_time(input, pulls.of_times(s), kLeastBlock_s), with_lags ? 2 : 1);
    const auto widen = [](double& sigma_s, double variance_s2) { sigma_s = std::max(sigma_s, std::sqrt(variance_s2)); };
    widen(solution.time_offset_sigma_s[s], scatter(0, 0));
    if (!with_lags) continue;
    widen(solution.position_lag_sigma_s[s], scatter(1, 1));
    solution.position_lag_sigma_s[s] = doubted_lag_sigma_s(problem.nodes, s, solution.position_lag_sigma_s[s],
                                                           problem.session_position_lag_sigma_s[s], input.narrow_field);
  }
}

std::optional<JointSolution> solve_with_times(const PairwiseInput& input, const JointProblem& problem,
                                              const PairwiseDetails& details, const Progress& progress) {
  JointSolution solution =
      solve_joint(problem, details.noise, details.joint.ins_from_lidar, kJointIterations, progress);
  if (!solution.converged || solution.time_offset_s.empty()) return std::nullopt;
  widen_by_blocks(input, problem, details, progress, solution);
  return solution;
}

std::optional<JointSolution> solve_with_lags(const PairwiseInput& input, JointProblem problem,
                                             const PairwiseDetails& details, const Progress& progress) {
  constexpr double kAnything_s = 1.0;
  if (input.motions_only) return std::nullopt;
  problem.session_position_lag_sigma_s.assign(input.sessions.size(), kAnything_s);
  return solve_with_times(input, problem, details, progress);
}

// Lags that nobody expects and that are left in X, but are more than chance makes of none in most drives: how far each
// of them moves X is a doubt of it (K14). Also of one that stands out: whether it can be taken out is not known here.
void doubt_likely_lags(const JointProblem& problem, const JointSolution& with_lags, const SolveOptions& options,
                       CalibrationResult& result) {
  constexpr double kSigmas = 2.0;
  const std::vector<double>& expected_s = problem.session_position_lag_sigma_s;
  for (motion::SessionIndex s; s < with_lags.position_lag_s.size(); ++s) {
    const bool expected = s < expected_s.size() && expected_s[s] > 0.0;
    const double lag_s = with_lags.position_lag_s[s];
    if (!expected && std::abs(lag_s) > kSigmas * with_lags.position_lag_sigma_s[s])
      add_doubt(lag_s * with_lags.moved_by_position_lag[s], say::unknown_positions_lag(), options, result);
  }
}

}  // namespace

double doubted_lag_sigma_s(const std::vector<JointNode>& nodes, motion::SessionIndex session, double sigma_s,
                           double prior_sigma_s, bool narrow_field) {
  constexpr double kDoubtful_mps = 0.2;
  // Registrations of a LiDAR that looks one way err along the way with the turn and with what lies ahead, as a lag
  // does: of eight drives without one, lags scattered by 1.9 times their sigma.
  const double share = narrow_field ? 0.25 : 1.0;
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  double squares = 0.0, count = 0.0;
  for (const JointNode& node : nodes) {
    const Eigen::Vector3d velocity = node.body_velocity.head<3>();
    if (node.session != session || velocity.isZero(0.0)) continue;  // zero: it is not known there
    sum += velocity;
    squares += velocity.squaredNorm();
    ++count;
  }
  const double variance = count > 0.0 ? std::max(0.0, squares / count - (sum / count).squaredNorm()) : 0.0;
  const double known_before = 1.0 / (prior_sigma_s * prior_sigma_s);
  const double told = std::max(0.0, 1.0 / (sigma_s * sigma_s) - known_before);
  const double believed = share * told * variance / (variance + kDoubtful_mps * kDoubtful_mps);
  return std::max(sigma_s, 1.0 / std::sqrt(known_before + believed));
}

void estimate_clock_offset(const PairwiseInput& input, const JointProblem& problem, const PairwiseDetails& details,
                           const Progress& progress, CalibrationResult& result) {
  JointProblem with_clock = problem;
  with_clock.estimate_time_offset = true;
  std::optional<JointSolution> solution = solve_with_times(input, with_clock, details, progress);
  if (auto with_lags = solve_with_lags(input, with_clock, details, progress)) {
    result.session_position_lag_s = with_lags->position_lag_s;
    result.session_position_lag_sigma_s = with_lags->position_lag_sigma_s;
    // A bias that is known has the lags in it.
    if (!input.clock_bias) doubt_likely_lags(problem, *with_lags, input.options, result);
    if (position_lag_differs(result)) solution = std::move(with_lags);
  }
  if (!solution) return;
  if (!std::ranges::all_of(solution->time_offset_sigma_s, [](double sigma_s) { return sigma_s > 0.0; })) return;
  result.time_offset = mean_time_offset(solution->time_offset_s, solution->time_offset_sigma_s);
  result.session_time_offset_s = solution->time_offset_s;
  result.session_time_offset_sigma_s = solution->time_offset_sigma_s;
  result.time_offset.in_sigma = problem.estimate_time_offset;
}

}  // namespace remount::calibration
