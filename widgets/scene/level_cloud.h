// A large cloud in an order of which every beginning shows the whole.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "algorithms/core/progress.h"

namespace remount::scene {

/// Points ordered by voxels: first one for the coarsest voxel that holds any, then one for each half as large that has
/// none yet, and so on. The first n points are therefore an even thinning of the cloud, for any n: what is drawn while
/// the camera moves is a beginning, what is drawn afterwards the whole.
struct LevelCloud {
  std::vector<Eigen::Vector3f> points;  ///< m; none that is not finite or beyond kFarthestReturn_m
  std::vector<std::uint32_t> original;  ///< index of each in the cloud that it comes from
  std::vector<std::size_t> level_end;   ///< how many points the voxels of each level have together with those before
  std::vector<float> level_edge_m;      ///< edge of the voxels of each level, halving; 0 for the rest at the end
  std::size_t left_out = 0;             ///< bad coordinates

  std::size_t size() const { return points.size(); }
};

/// Orders a cloud of at most 2^32 points. The same for the same cloud. Empty where `progress` is cancelled.
LevelCloud order_by_levels(const std::vector<Eigen::Vector3f>& points, const Progress& progress = {});

}  // namespace remount::scene
