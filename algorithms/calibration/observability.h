// Step 9: what the pairs determine, how well, and what to do about the rest.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "algorithms/calibration/calibration_result.h"
#include "algorithms/calibration/solve_options.h"

namespace remount {

/// How the vehicle moved, as far as it decides what can be observed.
struct MotionSummary {
  double largest_rotation_rad = 0.0;  ///< of one pair
  double largest_tilt_rad = 0.0;      ///< largest rotation about an axis other than the main one
};
MotionSummary summarise_motion(const std::vector<Pair>& pairs);

/// Fills `observed`, `covariance`, `directions` and `advice` of the result from the information and the covariance of X
/// under `perturbed`. A parameter counts as observed where its sigma is below the options' limit.
void describe_observability(const Matrix6d& information, const Matrix6d& covariance, const MotionSummary& motion,
                            const SolveOptions& options, CalibrationResult& result);

/// Covariance of (x, y, z, yaw, pitch, roll) from the covariance of the perturbation [dt; phi] of X.
Matrix6d parameter_covariance(const RigidTransform& ins_from_lidar, const Matrix6d& perturbation_covariance);

}  // namespace remount
