#include "model/simulator/surroundings.h"

#include <algorithm>

namespace remount::simulator {

Surroundings::Surroundings(const Scene& scene, const SimulationOptions& lidar, double time_s)
    : scene_(scene),
      ins_from_lidar_(lidar.ins_from_lidar),
      farthest_m_(std::min(lidar.max_range_m, lidar_model(lidar.lidar.model).figures.farthest_m)) {
  move_to(time_s);
}

void Surroundings::move_to(double time_s) {
  road_from_lidar_ = scene_.road_from_ins(time_s) * ins_from_lidar_;
  cars_.clear();
  for (const Box& box : scene_.traffic().boxes_at(time_s, road_from_lidar_.translation().head<2>(), farthest_m_))
    cars_.emplace_back(box);
  arm_ = scene_.arm(time_s);
}

RayHit Surroundings::cast(const Eigen::Vector3d& direction_in_lidar) const {
  const Ray ray{road_from_lidar_ * beams_begin_in_lidar_, road_from_lidar_.linear() * direction_in_lidar};
  RayHit hit = scene_.world().cast(ray, farthest_m_);
  if (!hit.found()) hit.distance_m = farthest_m_;
  for (const BoxCaster& car : cars_) car.cast(ray, 1.0 / ray.direction.z(), hit);
  for (const TiltedBox& box : arm_) cast_tilted_box(box, ray, hit);
  return hit;
}

}  // namespace remount::simulator
