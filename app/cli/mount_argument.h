// A LiDAR of a simulated vehicle, as it is typed.
#pragma once

#include <string>

#include "model/simulator/lidar_mount.h"

namespace remount::cli {

/// "NAME=KEY:VALUE,KEY:VALUE". Keys: `at` (x/y/z/yaw/pitch/roll in m and degrees), `phase` (s), `rate` (Hz), `points`,
/// `field`, and every option of the LiDAR by its name, with or without "lidar-" before it: "lidar:at128,beams:16,
/// ring-elevation-deg:0.1". What is not given is as `options` have it. Throws Error(Contract).
simulator::LidarMount parse_mount(const std::string& text, const simulator::SimulationOptions& options);

}  // namespace remount::cli
