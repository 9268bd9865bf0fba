#include "algorithms/calibration/trajectory/trajectory_condense.h"

#include <cmath>

#include "algorithms/calibration/trajectory/trajectory_spread.h"

namespace remount::calibration {
namespace {

// The most epochs that leave `kept` and end with a block.
std::size_t movable(const std::vector<TrajectoryEpoch>& epochs, std::size_t kept, double block_s) {
  if (epochs.size() <= kept) return 0;
  std::size_t count = epochs.size() - kept;
  while (count > 0 && block_of(epochs[count - 1].time_s, block_s) == block_of(epochs[count].time_s, block_s)) --count;
  return count;
}

// The first epochs as a session of their own, at the same solution.
struct FirstPart {
  TrajectoryProblem problem;
  TrajectorySolution solution;
};

FirstPart first_part(const TrajectoryProblem& problem, const TrajectorySolution& solution, std::size_t session,
                     std::size_t count) {
  FirstPart part;
  part.problem.nominal_ins_from_lidar = problem.nominal_ins_from_lidar;
  part.problem.estimate_clock = problem.estimate_clock;
  part.problem.position_lag_sigma_s = problem.position_lag_sigma_s;
  part.problem.estimate_odometry_drift = problem.estimate_odometry_drift;
  TrajectorySession& only = part.problem.sessions.emplace_back(problem.sessions[session]);
  only.epochs.resize(count);
  only.past = {};
  part.solution = solution;
  TrajectoryState& state = part.solution.state;
  state.enu_from_lidar = {solution.state.enu_from_lidar[session]};
  state.enu_from_lidar.front().resize(count);
  const OwnVector own = solution.state.own(session);
  state.scale = state.clock_s = {0.0};
  state.position_lag_s.clear();
  state.odometry_drift.clear();
  state.add_own(0, own);
  return part;
}

void add_blocks(const TrajectoryProblem& problem, const TrajectoryOptions& options, const TrajectorySolution& solution,
                const TrajectoryPrior& prior, std::size_t session, int before_block, double block_s,
                TrajectoryPast& past) {
  const WeightedTerms weighted = weighted_terms(problem, options, solution.state, solution.noise);
  const TrajectoryEquations equations(problem, options, weighted, solution.noise, prior.information);
  for (const auto& [block, pull] : block_pulls(problem, solution, weighted, equations, block_s)) {
    if (block.first != session || block.second >= before_block) continue;
    past.scatter += pull * pull.transpose();
    past.blocks += 1.0;
  }
}

// How the vehicle turned, in steps of seconds, and of more where there are many.
void add_turns(const std::vector<TrajectoryEpoch>& epochs, std::size_t count, TrajectoryPast& past) {
  constexpr double kApart_s = 5.0;
  constexpr std::size_t kMost = 400;
  double last_s = -kApart_s;
  for (std::size_t i = 0; i < count; ++i) {
    if (epochs[i].time_s - last_s < kApart_s) continue;
    last_s = epochs[i].time_s;
    past.odometry_from_lidar.push_back(epochs[i].odometry_from_lidar);
  }
  if (past.odometry_from_lidar.size() <= kMost) return;
  std::vector<RigidTransform> fewer;
  for (std::size_t i = 0; i < past.odometry_from_lidar.size(); i += 2) fewer.push_back(past.odometry_from_lidar[i]);
  past.odometry_from_lidar = std::move(fewer);
}

// Eliminates the poses of a part. False where its equations have no solution.
bool add_information(const FirstPart& part, const WeightedTerms& weighted, const BorderPoint& at,
                     TrajectoryPast& past) {
  const std::size_t count = part.problem.sessions.front().epochs.size();
  TrajectoryChain chain(count);
  ChainVector side(count);
  for (std::size_t k = 0; k < weighted.terms.front().size(); ++k) {
    const TrajectoryTerm& term = weighted.terms.front()[k];
    const double factor = part.solution.noise.of(term.kind);
    const double weight = weighted.weights.front()[k] / (factor * factor);
    chain.add(term, weight);
    TrajectoryChain::add_transposed(term, weight * term.residual, side);
  }
  if (!chain.factor()) return false;
  chain.reduce(side);
  past.pull = past.empty() ? BorderVector(side.border) : BorderVector(past.pull_at(at) + side.border);
  past.information += chain.reduced();
  if (past.empty()) past.linearised_ins_from_lidar = at.ins_from_lidar;
  past.centre = at;
  return true;
}

}  // namespace

std::size_t condense(std::size_t session, std::size_t kept, const TrajectoryOptions& options,
                     const TrajectoryPrior& prior, double block_s, TrajectoryProblem& problem,
                     TrajectorySolution& solution) {
  std::vector<TrajectoryEpoch>& epochs = problem.sessions[session].epochs;
  const std::size_t count = movable(epochs, kept, block_s);
  if (count == 0) return 0;
  const FirstPart part = first_part(problem, solution, session, count);
  const WeightedTerms weighted = weighted_terms(part.problem, options, part.solution.state, part.solution.noise);
  const TrajectoryEquations alone(part.problem, options, weighted, part.solution.noise, prior.information);
  TrajectoryPast past = problem.sessions[session].past;
  if (!alone.solvable() || !add_information(part, weighted, border_point(solution.state, session), past)) return 0;
  past.spurious +=
      spurious_trajectory_information(part.problem, options, part.solution, weighted, alone, prior.information);
  add_blocks(problem, options, solution, prior, session, block_of(epochs[count].time_s, block_s), block_s, past);
  add_turns(epochs, count, past);
  past.has_ins = past.has_ins || has_ins(part.problem);
  past.has_antenna = past.has_antenna || has_antenna(part.problem);
  past.duration_s += epochs[count].time_s - epochs.front().time_s;
  problem.sessions[session].past = std::move(past);
  const auto moved = static_cast<std::ptrdiff_t>(count);
  epochs.erase(epochs.begin(), epochs.begin() + moved);
  std::vector<RigidTransform>& poses = solution.state.enu_from_lidar[session];
  poses.erase(poses.begin(), poses.begin() + moved);
  return count;
}

}  // namespace remount::calibration
