// Making a long drive short: epochs become what they say.
#pragma once

#include "algorithms/calibration/trajectory/trajectory_solver.h"

namespace remount::calibration {

/// Moves the first epochs of a session from what is solved into its past, so that at least `kept` stay; they end with
/// a block of `block_s`, as trajectory_spread.h counts them. The one step of the odometry that leads from them to the
/// next epoch is given up. Unchanged where nothing can be moved. Returns how many were.
/// @param solution of `problem`, converged; its poses go with the epochs
std::size_t condense(std::size_t session, std::size_t kept, const TrajectoryOptions& options,
                     const TrajectoryPrior& prior, double block_s, TrajectoryProblem& problem,
                     TrajectorySolution& solution);

}  // namespace remount::calibration
