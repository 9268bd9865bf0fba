#include "model/simulator/scene.h"

#include <algorithm>
#include <cmath>

#include "model/simulator/speed_profile.h"

namespace remount {

Scene::Scene(const SimulationOptions& options)
    : options_(options),
      road_(options.scenario, options.speed_mps),
      ground_(scenario_ground(options.scenario, options.seed)),
      world_(build_world(road_, ground_, options.speed_mps * options.duration_s, options.seed)),
      traffic_(road_, ground_, options),
      enu_from_road_(make_rigid(rotation_from_yaw_pitch_roll({degrees_to_radians(options.heading_deg), 0.0, 0.0}),
                                Eigen::Vector3d::Zero())) {}

RigidTransform Scene::road_from_vehicle(double time_s) const {
  return remount::road_from_vehicle(road_, ground_, along_road_m(options_, time_s));
}

RigidTransform Scene::road_from_ins(double time_s) const { return road_from_vehicle(time_s) * vehicle_from_ins(); }

std::size_t scan_count(const SimulationOptions& options) {
  // Against rounding: 12 s at 10 Hz are 120 scans.
  return static_cast<std::size_t>(std::max(1.0, std::floor(options.duration_s * options.scan_rate_hz + 1e-6)));
}

double scan_time_s(const SimulationOptions& options, std::size_t scan) {
  return (static_cast<double>(scan) + 0.5) / options.scan_rate_hz;
}

}  // namespace remount
