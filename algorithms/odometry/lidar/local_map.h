// The surroundings of the sensor as its last keyframes saw them.
#pragma once

#include <deque>
#include <memory>
#include <vector>

#include "algorithms/geometry/rigid_transform.h"
#include "algorithms/registration/prepared_cloud.h"

namespace remount::odometry {

/// Points of recent keyframes, joined into one cloud in the frame of the newest: coordinates stay small however far the
/// drive goes, and normals face where the sensor is now.
class LocalMap {
 public:
  LocalMap(registration::RegistrationOptions options, std::size_t most_keyframes)
      : options_(options), most_keyframes_(std::max<std::size_t>(1, most_keyframes)) {}

  /// Adds a keyframe, forgets the oldest beyond the limit and joins the rest anew.
  void insert(const registration::PreparedCloud& scan, const RigidTransform& odometry_from_lidar,
              const Progress& progress);
  void clear();

  bool empty() const { return keyframes_.empty(); }
  /// In the LiDAR frame of the newest keyframe. Not before the first insert.
  const registration::PreparedCloud& cloud() const { return *cloud_; }
  const RigidTransform& odometry_from_map() const { return keyframes_.back().odometry_from_lidar; }

 private:
  struct MapKeyframe {
    RigidTransform odometry_from_lidar = RigidTransform::Identity();
    std::vector<Eigen::Vector3f> points;  ///< LiDAR frame of the keyframe
  };
  registration::RegistrationOptions options_;
  std::size_t most_keyframes_;
  std::deque<MapKeyframe> keyframes_;
  std::unique_ptr<registration::PreparedCloud> cloud_;
};

}  // namespace remount::odometry
