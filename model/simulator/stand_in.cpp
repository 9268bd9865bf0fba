#include "model/simulator/stand_in.h"

#include <algorithm>

#include "algorithms/core/error.h"
#include "messages/simulation.h"

namespace remount::simulator {

SimulatedScanSource scans_of_model(const SimulatedDrive& drive, std::span<const std::string_view> models,
                                   const std::string& format) {
  const Scene* scene = scene_of(drive.session.scans);
  if (scene == nullptr) throw Error(ErrorCode::Contract, format, say::simulation_sensor_not_simulated());
  SimulationOptions options = *lidar_options_of(drive.session.scans);
  if (!options.motion_distortion) throw Error(ErrorCode::Contract, format, say::simulation_sensor_not_distorted());
  const std::string_view own = lidar_model(options.lidar.model).id;
  if (std::find(models.begin(), models.end(), own) == models.end()) options.lidar.model = lidar_named(models.front());
  options.lidar.points_per_scan = 0;
  options.per_point_time = true;
  return {std::shared_ptr<const Scene>(drive.session.scans, scene), options};
}

}  // namespace remount::simulator
