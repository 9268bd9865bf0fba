// The true motion of something that is fixed to the simulated vehicle.
#pragma once

#include "model/simulator/scene.h"

namespace remount::simulator {

struct BodyMotion {
  RigidTransform road_from_body = RigidTransform::Identity();
  Eigen::Vector3d velocity_in_road_mps = Eigen::Vector3d::Zero();
  Eigen::Vector3d acceleration_in_road_mps2 = Eigen::Vector3d::Zero();
  Eigen::Vector3d rate_in_body_radps = Eigen::Vector3d::Zero();
};

/// Derivatives by central differences of eighth order over a few centimetres of road: for the roads of the simulator
/// good to better than 1e-6 m/s^2 and 1e-8 rad/s.
BodyMotion body_motion(const Scene& scene, const RigidTransform& vehicle_from_body, double time_s);

}  // namespace remount::simulator
