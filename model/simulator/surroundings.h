// What the rays of the LiDAR meet: the world, and what moves in it.
#pragma once

#include <vector>

#include "model/simulator/scene.h"

namespace remount::simulator {

class Surroundings {
 public:
  /// At a time of the drive, s; as far as the LiDAR sees.
  Surroundings(const Scene& scene, double time_s) : Surroundings(scene, scene.options(), time_s) {}
  /// @param lidar of a LiDAR of its own: its range, and where it sits
  Surroundings(const Scene& scene, const SimulationOptions& lidar, double time_s);

  void move_to(double time_s);
  /// Of beams that do not begin at the LiDAR's origin.
  void begin_beams_at(const Eigen::Vector3d& point_in_lidar) { beams_begin_in_lidar_ = point_in_lidar; }
  double farthest_m() const { return farthest_m_; }
  /// The first surface; one at farthest_m() or beyond is none.
  /// @param direction_in_lidar unit length
  RayHit cast(const Eigen::Vector3d& direction_in_lidar) const;

 private:
  const Scene& scene_;
  RigidTransform ins_from_lidar_ = RigidTransform::Identity();
  double farthest_m_;
  RigidTransform road_from_lidar_ = RigidTransform::Identity();
  Eigen::Vector3d beams_begin_in_lidar_ = Eigen::Vector3d::Zero();
  std::vector<BoxCaster> cars_;
  std::vector<TiltedBox> arm_;
};

}  // namespace remount::simulator
