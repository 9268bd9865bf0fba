// Thinning of a scan: one point, the centroid, for each voxel that has any.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "algorithms/core/progress.h"

namespace remount::registration {

/// Centroids of the points in each voxel, m, which must be finite (readers and PreparedCloud see to it), in the order
/// in which their voxels first appear; coordinates beyond 2^20 voxels count as the last. Empty where `progress` is
/// cancelled.
std::vector<Eigen::Vector3f> voxel_centroids(const std::vector<Eigen::Vector3f>& points, float voxel_m,
                                             const Progress& progress = {});

}  // namespace remount::registration
