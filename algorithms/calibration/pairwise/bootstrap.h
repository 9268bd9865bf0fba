// Sigma from the scatter between blocks of time, which does not believe the noise model.
#pragma once

#include <vector>

#include "algorithms/calibration/joint/measurement_pulls.h"
#include "algorithms/calibration/pairwise/pairwise.h"

namespace remount::calibration {

/// How far one measurement moves unknowns, and the block of time that it belongs to.
struct BlockPull {
  Eigen::VectorXd step;
  std::size_t block = 0;
};

/// Pulls by blocks of the length that the options name, shorter where the drive is: it shall have twenty, but none
/// shorter than `least_s`.
std::vector<BlockPull> blocks_of_time(const PairwiseInput& input, const std::vector<MeasurementPull>& pulls,
                                      double least_s = 1e-3);

/// Covariance of what the pulls move over resamplings of whole blocks of time with replacement: in closed form, for
/// to first order unknowns move by the sum of what their blocks pull. Blocks, because neighbours in time share
/// surroundings and what their INS suffers. Nothing is computed (zero matrix) from fewer than four blocks.
/// docs/maths/covariance.md (C17)
Eigen::MatrixXd bootstrap_covariance(const std::vector<BlockPull>& pulls, Eigen::Index unknowns);

}  // namespace remount::calibration
