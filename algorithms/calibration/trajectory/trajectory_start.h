// A first trajectory and a first X that gross outliers cannot pull.
#pragma once

#include "algorithms/calibration/solve_options.h"
#include "algorithms/calibration/trajectory/trajectory_solver.h"

namespace remount::calibration {

/// X from motions of INS and LiDAR (robust_start), poses from the odometry laid through the INS poses or the fixes
/// around each of them (medians). Where the fixes lie on a line, the roll about it is chosen so that the LiDAR's z axis
/// at the start points up.
TrajectorySolution start_trajectory(const TrajectoryProblem& problem, const TrajectoryOptions& options,
                                    const Progress& progress);

}  // namespace remount::calibration
