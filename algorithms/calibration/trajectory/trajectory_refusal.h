// Why a trajectory alignment has no answer.
#pragma once

#include <optional>

#include "algorithms/calibration/trajectory/trajectory_answer.h"

namespace remount::calibration {

/// An answer that claims nothing.
TrajectoryAnswer without_numbers(Status status, Message message);

/// What refuses a solution: trajectories that did not come together, or of which one is of another unit. Of what did
/// come together only the scale of the odometry that was found says so, for in tight turns a LiDAR far from the INS
/// goes another way than it does.
/// @param aligned whether the solution converged, and measurements and odometry do not contradict each other
std::optional<TrajectoryAnswer> refusal_of(const TrajectoryProblem& problem, const TrajectoryOptions& options,
                                           const TrajectoryState& state, bool aligned);

}  // namespace remount::calibration
