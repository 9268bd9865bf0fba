// What the rays of the LiDAR meet: the world, and what moves in it.
#pragma once

#include <vector>

#include "model/simulator/scene.h"

namespace remount::simulator {

class Surroundings {
 public:
  /// At a time of the drive, s; as far as the LiDAR sees.
  Surroundings(const Scene& scene, double time_s);

  void move_to(double time_s);
  double farthest_m() const { return farthest_m_; }
  /// The first surface; one at farthest_m() or beyond is none.
  /// @param direction_in_lidar unit length
  RayHit cast(const Eigen::Vector3d& direction_in_lidar) const;

 private:
  const Scene& scene_;
  double farthest_m_;
  RigidTransform road_from_lidar_;
  std::vector<BoxCaster> cars_;
  std::vector<TiltedBox> arm_;
};

}  // namespace remount::simulator
