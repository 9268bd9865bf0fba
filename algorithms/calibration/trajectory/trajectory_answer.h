// What a solved trajectory alignment says about X, the antenna and the odometry, and how sure that is.
#pragma once

#include <string>

#include "algorithms/calibration/calibration_result.h"
#include "algorithms/calibration/method_details.h"
#include "algorithms/calibration/solve_options.h"
#include "algorithms/calibration/trajectory/trajectory_solver.h"

namespace remount::calibration {

/// Id of the quantity that is the antenna's place in the LiDAR's frame along x, y or z (axis 0 to 2).
inline std::string lever_arm_id(int axis) { return std::string("lever arm ") + "xyz"[axis]; }

struct TrajectoryAnswer {
  /// Of the INS where any epoch has its poses. Of the antenna otherwise: a frame at the antenna with the axes of the
  /// LiDAR, for positions have none of their own, so that only the translation can be observed.
  CalibrationResult result;
  std::vector<NamedQuantity> quantities;  ///< lever arm of the antenna, heading and scale of the odometry
  /// Information that holds the shared unknowns along the directions that are not observed.
  SharedMatrix hold = SharedMatrix::Zero();
  /// Of a session's odometry, the largest share of its way that it drifts by and that stands out of its error; 0: none.
  double odometry_drift = 0.0;
  /// Share of each session in the common clock offset; 0 where a session says nothing of it. Empty: not estimated.
  std::vector<double> clock_weights;
};

/// @param thorough also compares sessions with each other, which can only make sigmas larger
TrajectoryAnswer describe_trajectory(const TrajectoryProblem& problem, const TrajectoryOptions& options,
                                     const SolveOptions& judged_by, const TrajectorySolution& solution,
                                     const TrajectoryPrior& prior, bool thorough);

/// Takes X, lever arm, scales and clocks of an answer from a state; what is known about them stays.
void set_values(const TrajectoryState& state, TrajectoryAnswer& answer);

/// What is expected of X and the antenna before any data: the nominal (or the INS itself, turned as in `start`) within
/// metres and a tenth of a radian, the antenna within its reach of the LiDAR.
TrajectoryPrior weak_trajectory_prior(const TrajectoryProblem& problem, const TrajectoryOptions& options,
                                      const RigidTransform& start_ins_from_lidar);

}  // namespace remount::calibration
