#include "model/simulator/scene.h"

#include <algorithm>
#include <cmath>

#include "model/simulator/scenario_world.h"
#include "model/simulator/slew_yard.h"
#include "model/simulator/speed_profile.h"

namespace remount::simulator {

namespace {
/// Of the road frame about its y axis: the yard's slope falls ahead.
double slope_rad(const SimulationOptions& options) {
  return options.scenario == ScenarioKind::SlewYard ? degrees_to_radians(options.slew_yard.slope_deg) : 0.0;
}
}  // namespace

Scene::Scene(const SimulationOptions& options)
    : options_(options),
      road_(options.scenario, options.speed_mps),
      ground_(scenario_ground(options.scenario, options.seed)),
      world_(build_scenario_world(road_, ground_, options)),
      traffic_(road_, ground_, options),
      enu_from_road_(
          make_rigid(rotation_from_yaw_pitch_roll({degrees_to_radians(options.heading_deg), slope_rad(options), 0.0}),
                     Eigen::Vector3d::Zero())) {}

RigidTransform Scene::road_from_vehicle(double time_s) const {
  if (options_.scenario == ScenarioKind::SlewYard)
    return road_from_upper_body(options_.slew_yard, options_.duration_s, time_s);
  return simulator::road_from_vehicle(road_, ground_, along_road_m(options_, time_s));
}

std::vector<TiltedBox> Scene::arm(double time_s) const {
  if (options_.scenario != ScenarioKind::SlewYard) return {};
  return arm_boxes(options_.slew_yard, options_.duration_s, time_s);
}

RigidTransform Scene::road_from_ins(double time_s) const { return road_from_vehicle(time_s) * vehicle_from_ins(); }

std::size_t scan_count(const SimulationOptions& options) {
  // Against rounding: 12 s at 10 Hz are 120 scans.
  return static_cast<std::size_t>(
      std::max(1.0, std::floor((options.duration_s - options.scan_phase_s) * options.scan_rate_hz + 1e-6)));
}

double stamp_share(const SimulationOptions& options) { return lidar_model(options.lidar.model).spins ? 0.5 : 0.0; }

double scan_time_s(const SimulationOptions& options, std::size_t scan) {
  return options.scan_phase_s + (static_cast<double>(scan) + stamp_share(options)) / options.scan_rate_hz;
}

}  // namespace remount::simulator
