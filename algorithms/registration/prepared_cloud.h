// A scan prepared for registration: thinned, with normals and a search tree. Made once, shared by all its pairs.
#pragma once

#include <memory>
#include <vector>

#include "algorithms/cloud/point_cloud.h"
#include "algorithms/registration/registration_options.h"

namespace remount {

/// Nearest neighbour of a query, and how far the next one is: what is needed to keep it without a new search.
struct Neighbour {
  int index = -1;                ///< -1: none within the radius
  float distance_m = 0.0f;       ///< to the neighbour
  float next_distance_m = 0.0f;  ///< to the second nearest, or the radius where there is none within it
};

/// Immutable and thread-safe. Points are in the lidar frame; those without a surface normal are left out.
class PreparedCloud {
 public:
  /// Thins by voxels (centroids), drops points outside the range limits and fits normals to the neighbourhood.
  /// @param left_out true for points of the cloud not to be used (moving objects); empty for none
  PreparedCloud(const PointCloud& cloud_in_lidar, const RegistrationOptions& options,
                const std::vector<bool>& left_out = {});
  ~PreparedCloud();
  PreparedCloud(const PreparedCloud&) = delete;
  PreparedCloud& operator=(const PreparedCloud&) = delete;

  std::size_t size() const { return points_.size(); }
  const std::vector<Eigen::Vector3f>& points() const { return points_; }    ///< m
  const std::vector<Eigen::Vector3f>& normals() const { return normals_; }  ///< unit length, towards the sensor
  const std::vector<float>& planarity() const { return planarity_; }        ///< 0 (scattered) to 1 (a plane)
  Neighbour nearest(const Eigen::Vector3f& query, float radius_m) const;
  std::size_t bytes() const;  ///< memory held, for cache bounds

 private:
  struct Tree;
  std::vector<Eigen::Vector3f> points_, normals_;
  std::vector<float> planarity_;
  std::unique_ptr<Tree> tree_;
};

/// Centroids of the points in each voxel, ordered by voxel; the same for any order of threads.
std::vector<Eigen::Vector3f> voxel_centroids(const std::vector<Eigen::Vector3f>& points, float voxel_m);

}  // namespace remount
