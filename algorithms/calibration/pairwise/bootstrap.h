// Sigma from the scatter between blocks of time, which does not believe the noise model.
#pragma once

#include <vector>

#include "algorithms/geometry/rigid_transform.h"

namespace remount::calibration {

/// How far one measurement moves X (under `perturbed`), and the block of time that it belongs to.
struct BlockPull {
  Vector6d step = Vector6d::Zero();
  std::size_t block = 0;
};

/// Covariance of X (under `perturbed`) over resamplings of whole blocks of time with replacement: in closed form, for
/// to first order X moves by the sum of what its blocks pull. Blocks, because neighbours in time share surroundings and
/// what their INS suffers. Nothing is computed (zero matrix) from fewer than four blocks.
Matrix6d bootstrap_covariance(const std::vector<BlockPull>& pulls);

}  // namespace remount::calibration
