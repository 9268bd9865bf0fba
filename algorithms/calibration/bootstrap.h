// Sigma from resampling, which does not believe the noise model.
#pragma once

#include <array>
#include <vector>

#include "algorithms/core/progress.h"
#include "algorithms/geometry/rigid_transform.h"

namespace remount {

/// What one pair says about X at the solution: 1/2 d' H d - s' d, and the block of time that it belongs to.
struct PairInfluence {
  Matrix6d hessian = Matrix6d::Zero();
  Vector6d side = Vector6d::Zero();
  int block = 0;
};

/// Covariance of X (under `perturbed`) over resamplings of whole blocks of time with replacement, one Newton step each;
/// blocks, because neighbouring pairs share fixes and scans. `prior` (information) holds what a resample does not
/// determine. Deterministic for a seed. Nothing is computed (zero matrix) from fewer than four blocks.
Matrix6d bootstrap_covariance(const std::vector<PairInfluence>& pairs, const Matrix6d& prior, int samples, int seed,
                              const Progress& progress);

}  // namespace remount
