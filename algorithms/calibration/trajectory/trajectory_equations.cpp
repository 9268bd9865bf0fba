#include "algorithms/calibration/trajectory/trajectory_equations.h"

#include <Eigen/LU>

namespace remount::calibration {
namespace {

OwnVector own_information(const TrajectoryOptions& options, const TrajectoryProblem& problem) {
  constexpr double kHeld = 1e12, kClock_s = 0.2, kDrift = 0.01;
  const double scale = 0.01 * options.odometry_scale_percent;
  const auto unless_held = [](bool open, double sigma) { return open ? 1.0 / (sigma * sigma) : kHeld; };
  OwnVector out;
  out << unless_held(scale > 0.0, scale), unless_held(problem.estimate_clock, kClock_s),
      unless_held(problem.position_lag_sigma_s > 0.0, problem.position_lag_sigma_s),
      Eigen::Vector3d::Constant(unless_held(problem.estimate_odometry_drift, kDrift));
  return out;
}

}  // namespace

std::vector<ChainVector> zero_sides(const TrajectoryProblem& problem) {
  std::vector<ChainVector> sides;
  for (const TrajectorySession& session : problem.sessions) sides.emplace_back(session.epochs.size());
  return sides;
}

TrajectoryEquations::TrajectoryEquations(const TrajectoryProblem& problem, const TrajectoryOptions& options,
                                         const WeightedTerms& weighted, const TrajectoryNoise& noise,
                                         const SharedMatrix& prior_information)
    : own_prior_(own_information(options, problem)) {
  SharedMatrix sum = prior_information;
  for (std::size_t s = 0; s < problem.sessions.size(); ++s) {
    chains_.emplace_back(problem.sessions[s].epochs.size());
    for (std::size_t k = 0; k < weighted.terms[s].size(); ++k) {
      const TrajectoryTerm& term = weighted.terms[s][k];
      const double factor = noise.of(term.kind);
      chains_[s].add(term, weighted.weights[s][k] / (factor * factor));
    }
    solvable_ = chains_[s].factor();
    if (!solvable_) return;
    const BorderMatrix border = chains_[s].reduced() + problem.sessions[s].past.information;
    OwnMatrix own = border.bottomRightCorner<kOwnSize, kOwnSize>();
    own.diagonal() += own_prior_;
    own_inverse_.push_back(own.inverse());
    own_link_.push_back(border.bottomLeftCorner<kOwnSize, kSharedSize>());
    information_.push_back(border.topLeftCorner<kSharedSize, kSharedSize>() -
                           own_link_[s].transpose() * own_inverse_[s] * own_link_[s]);
    sum += information_[s];
  }
  shared_.compute(sum);
  solvable_ = shared_.info() == Eigen::Success;
}

SharedMatrix TrajectoryEquations::information() const {
  SharedMatrix sum = SharedMatrix::Zero();
  for (const SharedMatrix& one : information_) sum += one;
  return sum;
}

std::vector<ChainVector> TrajectoryEquations::solve(std::vector<ChainVector> sides, const SharedVector& shared) const {
  SharedVector sum = shared;
  for (std::size_t s = 0; s < chains_.size(); ++s) {
    chains_[s].reduce(sides[s]);
    sum += sides[s].border.head<kSharedSize>() -
           own_link_[s].transpose() * own_inverse_[s] * sides[s].border.tail<kOwnSize>();
  }
  const SharedVector step = shared_.solve(sum);
  for (std::size_t s = 0; s < chains_.size(); ++s) {
    BorderVector border;
    border << step, own_inverse_[s] * (sides[s].border.tail<kOwnSize>() - own_link_[s] * step);
    chains_[s].substitute(border, sides[s]);
  }
  return sides;
}

TrajectoryEquations::Sensitivity TrajectoryEquations::sensitivity(std::size_t session) const {
  Sensitivity out;
  out.own = -own_inverse_[session] * own_link_[session];
  for (const auto& pose : chains_[session].sensitivity())
    out.poses.push_back(pose.leftCols<kSharedSize>() + pose.rightCols<kOwnSize>() * out.own);
  return out;
}

}  // namespace remount::calibration
