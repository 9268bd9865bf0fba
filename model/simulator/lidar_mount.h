// The LiDARs of a simulated vehicle that has several.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "model/simulator/simulation_options.h"

namespace remount::simulator {

/// One LiDAR: its name, and what it is.
struct LidarMount {
  std::string name;  ///< letters, digits, '_' and '-'; sessions have it as lidar_name
  /// Of which what is_lidar_option names, `ins_from_lidar` and `scan_phase_s` count. All else is of the vehicle.
  SimulationOptions options;
};

/// Whether an option is of the LiDAR, so that each LiDAR of a vehicle may have its own.
bool is_lidar_option(std::string_view name);

/// The options of one LiDAR: those of the vehicle, with what the mount says of the LiDAR, and a seed that follows from
/// the vehicle's and the name. What a LiDAR measures so depends on no other LiDAR.
SimulationOptions options_of_mount(const SimulationOptions& vehicle, const LidarMount& mount);

/// What is wrong with the mounts as such: no LiDAR or too many, names that are none or stand twice.
std::vector<Message> mount_problems(const std::vector<LidarMount>& mounts);

}  // namespace remount::simulator
