// What the result of a job warns of, in few words: its file has all.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "model/drive/finding.h"
#include "model/results/vehicle_file.h"

namespace remount::fleet {

struct JobWarnings {
  std::size_t count = 0;                 ///< warnings and problems
  std::vector<drive::Finding> problems;  ///< those of them that are problems
};

/// Of all LiDARs, and of what they have to do with each other.
JobWarnings warnings_in(const results::VehicleFile& vehicle);
/// Of one LiDAR, and of what the vehicle says of it or of all.
JobWarnings warnings_of(const results::VehicleFile& vehicle, const results::LidarResult& lidar);

/// "top [lidars-contradict]".
std::string name_of_problem(const drive::Finding& problem);

}  // namespace remount::fleet
