// How trajectory alignment's information comes about: by noise, by blocks of time, by sessions.
#pragma once

#include <map>

#include "algorithms/calibration/pairwise/session_agreement.h"
#include "algorithms/calibration/trajectory/trajectory_solver.h"

namespace remount::calibration {

/// What the shared unknowns would seem to be determined by if no vehicle had turned at all: attitudes are estimates,
/// and their errors pass for turns that show a lever arm. Measured by adding such errors once more.
SharedMatrix spurious_trajectory_information(const TrajectoryProblem& problem, const TrajectoryOptions& options,
                                             const TrajectorySolution& solution, const WeightedTerms& weighted,
                                             const TrajectoryEquations& equations,
                                             const SharedMatrix& prior_information);

/// Number of the block of time that a time lies in.
inline int block_of(double time_s, double block_s) { return static_cast<int>(time_s / block_s); }

/// What each block of time of each session draws the shared unknowns by, poses and own unknowns following.
using BlockPulls = std::map<std::pair<std::size_t, int>, SharedVector>;
BlockPulls block_pulls(const TrajectoryProblem& problem, const TrajectorySolution& solution,
                       const WeightedTerms& weighted, const TrajectoryEquations& equations, double block_s);

/// Scatter of the shared unknowns as blocks of time show it (sandwich estimator: Huber 1967), whatever the correlation
/// of the errors within a block.
SharedMatrix scatter_of_blocks(const TrajectoryProblem& problem, const TrajectorySolution& solution,
                               const WeightedTerms& weighted, const TrajectoryEquations& equations,
                               const SharedMatrix& prior_information, double block_s);

/// What each session says of X on its own. Empty with a single session.
std::vector<SessionAnswer> trajectory_session_answers(const TrajectoryProblem& problem,
                                                      const TrajectorySolution& solution, const WeightedTerms& weighted,
                                                      const TrajectoryEquations& equations,
                                                      const SharedMatrix& prior_information);

/// Information of X (the first six) with the antenna marginalised, or of the antenna with X marginalised.
Matrix6d information_of_x(const SharedMatrix& information, const SharedMatrix& prior_information);
Eigen::Matrix3d information_of_antenna(const SharedMatrix& information, const SharedMatrix& prior_information);

}  // namespace remount::calibration
