#include "model/simulator/body_motion.h"

#include <algorithm>
#include <array>

namespace remount::simulator {

using Eigen::Vector3d;

BodyMotion body_motion(const Scene& scene, const RigidTransform& vehicle_from_body, double time_s) {
  constexpr std::array<double, 4> first{4.0 / 5.0, -1.0 / 5.0, 4.0 / 105.0, -1.0 / 280.0};
  constexpr std::array<double, 4> second{8.0 / 5.0, -1.0 / 5.0, 8.0 / 315.0, -1.0 / 560.0};
  // Short against the shortest wave of the ground, long against the rounding of positions kilometres away.
  const double step_s = std::clamp(0.08 / scene.options().speed_mps, 0.001, 0.02);
  const auto pose = [&](double t) { return scene.road_from_vehicle(t) * vehicle_from_body; };
  BodyMotion motion;
  motion.road_from_body = pose(time_s);
  const Vector3d here = motion.road_from_body.translation();
  const Eigen::Matrix3d body_from_road = motion.road_from_body.linear().transpose();
  for (std::size_t k = 0; k < first.size(); ++k) {
    const double away_s = static_cast<double>(k + 1) * step_s;
    const RigidTransform before = pose(time_s - away_s), after = pose(time_s + away_s);
    motion.velocity_in_road_mps += first[k] / step_s * (after.translation() - before.translation());
    motion.acceleration_in_road_mps2 +=
        second[k] / (step_s * step_s) * ((after.translation() - here) + (before.translation() - here));
    motion.rate_in_body_radps +=
        first[k] / step_s * (so3_log(body_from_road * after.linear()) - so3_log(body_from_road * before.linear()));
  }
  return motion;
}

}  // namespace remount::simulator
