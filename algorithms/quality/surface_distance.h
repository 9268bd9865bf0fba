// How far the points of one scan are from the surfaces that another one saw.
#pragma once

#include <memory>
#include <vector>

#include "algorithms/cloud/point_cloud.h"
#include "algorithms/core/progress.h"
#include "algorithms/geometry/rigid_transform.h"

namespace remount::registration {
class PreparedCloud;
}  // namespace remount::registration

namespace remount::quality {

/// The surfaces of one scan, the target, to be asked for distances. Immutable and thread-safe.
class SurfaceDistance {
 public:
  /// Farther away than this, m, nothing of the target counts as what a point belongs to.
  static constexpr float kReach_m = 1.0F;

  /// Points of the target that are not finite are ignored. Without surfaces, or cancelled, every distance is NaN.
  explicit SurfaceDistance(const cloud::PointCloud& target_in_lidar, const Progress& progress = {});
  ~SurfaceDistance();
  SurfaceDistance(SurfaceDistance&&) noexcept;
  SurfaceDistance& operator=(SurfaceDistance&&) noexcept;

  /// Distance of each point, m, in the order of the points: along the normal where the target has a plane there (rings
  /// are apart, and what lies between them is still the same wall), else to its nearest point, each thinned to voxels.
  /// NaN where the target has nothing within kReach_m, and for points that are not finite. Empty where cancelled.
  std::vector<float> of(const std::vector<Eigen::Vector3f>& points_in_source, const RigidTransform& target_from_source,
                        const Progress& progress = {}) const;
  /// The same with a side: negative behind a plane of the target, as the target's LiDAR sees it.
  std::vector<float> signed_of(const std::vector<Eigen::Vector3f>& points_in_source,
                               const RigidTransform& target_from_source, const Progress& progress = {}) const;

 private:
  std::unique_ptr<const registration::PreparedCloud> target_;
};

/// Median of the distances that are not NaN, without their sides; NaN where all are.
float median_distance_m(std::vector<float> distances_m);

}  // namespace remount::quality
