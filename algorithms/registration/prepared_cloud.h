// A scan prepared for registration: thinned, with normals and a search tree. Made once, shared by all its pairs.
#pragma once

#include <vector>

#include "algorithms/cloud/point_cloud.h"
#include "algorithms/registration/block_tree.h"
#include "algorithms/registration/registration_options.h"

namespace remount::registration {

/// Nearest neighbour of a query, and how far the query may move before there can be a nearer one.
struct Neighbour {
  int index = -1;           ///< -1: none within the radius
  float distance_m = 0.0f;  ///< to the neighbour
  float reach_m = 0.0f;     ///< the neighbour stays the nearest while the query has moved by less; at least 0
};

/// Immutable and thread-safe. Points are in the lidar frame, neighbours next to each other; those without a surface
/// normal are left out.
class PreparedCloud {
 public:
  /// Thins by voxels (centroids), drops points that are not finite or outside the range limits, and fits normals to the
  /// neighbourhood. Empty where `progress` is cancelled meanwhile.
  /// @param left_out true for points of the cloud not to be used (moving objects); empty for none
  PreparedCloud(const cloud::PointCloud& cloud_in_lidar, const RegistrationOptions& options,
                const std::vector<bool>& left_out = {}, const Progress& progress = {});
  PreparedCloud(const PreparedCloud&) = delete;
  PreparedCloud& operator=(const PreparedCloud&) = delete;

  std::size_t size() const { return tree_.size(); }
  Eigen::Vector3f point(std::size_t i) const;   ///< m
  Eigen::Vector3f normal(std::size_t i) const;  ///< unit length, towards the sensor
  /// How far the surface is trusted, 0 (scattered or thick) to 1 (a thin plane).
  float planarity(std::size_t i) const { return block_of(i).planarity[lane_of(i)]; }
  std::vector<Eigen::Vector3f> copy_points() const;  ///< all of them, m
  Neighbour nearest(const Eigen::Vector3f& query, float radius_m) const;
  const BlockTree& tree() const { return tree_; }
  std::size_t bytes() const;  ///< memory held, for cache bounds

 private:
  static std::size_t lane_of(std::size_t i) { return i % static_cast<std::size_t>(kBlockSize); }
  const PointBlock& block_of(std::size_t i) const { return tree_.blocks()[i / static_cast<std::size_t>(kBlockSize)]; }

  BlockTree tree_;
};

}  // namespace remount::registration
