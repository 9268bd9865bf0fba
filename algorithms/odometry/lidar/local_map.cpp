#include "algorithms/odometry/lidar/local_map.h"

namespace remount::odometry {

void LocalMap::insert(const registration::PreparedCloud& scan, const RigidTransform& odometry_from_lidar,
                      const Progress& progress) {
  keyframes_.push_back({odometry_from_lidar, scan.copy_points()});
  if (keyframes_.size() > most_keyframes_) keyframes_.pop_front();
  cloud::PointCloud joined;
  for (const MapKeyframe& keyframe : keyframes_) {
    const Eigen::Isometry3f here_from_keyframe =
        (odometry_from_lidar.inverse() * keyframe.odometry_from_lidar).cast<float>();
    for (const Eigen::Vector3f& point : keyframe.points) joined.points.push_back(here_from_keyframe * point);
  }
  registration::RegistrationOptions whole = options_;
  whole.min_range_m = 0.0;  // the vehicle was left out of each scan; where it stands now is ground
  cloud_ = std::make_unique<registration::PreparedCloud>(joined, whole, std::vector<bool>{}, progress);
}

void LocalMap::clear() {
  keyframes_.clear();
  cloud_.reset();
}

}  // namespace remount::odometry
