// Errors that all registrations of a calibration have in common. docs/maths/covariance.md (C20)
#pragma once

#include "algorithms/calibration/joint/joint_solver.h"

namespace remount::calibration {

/// Where surroundings stay alike along the road (a tunnel, a wall) beams and voxels see them alike, and every
/// registration is off the same way by tenths of a millimetre and some millidegrees. Where the motion of the vehicle is
/// alike as well, X takes that up, and no residual shows it.
struct SharedErrors {
  /// Their size in this drive over the usual one, estimated from what residuals do show of them.
  double size = 0.0;
  /// How X moves under `perturb` (m, rad) with each of them, a column of 1 sigma each: errors [nu; omega] in the axes
  /// of lidar b, those of the shortest motions first, then those of the longest; in between in proportion.
  Eigen::Matrix<double, 6, 12> responses = Eigen::Matrix<double, 6, 12>::Zero();
};

/// @param solution of the problem. Zero where its equations are singular.
SharedErrors shared_errors(const JointProblem& problem, const NoiseModel& noise, const JointSolution& solution);

}  // namespace remount::calibration
