// Several LiDARs of a vehicle in one calibration.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "app/cli/lidar_choice.h"
#include "app/cli/named_nominals.h"
#include "model/settings/settings.h"

namespace remount::cli {

struct VehicleJob {
  std::vector<std::filesystem::path> recordings;
  std::vector<ChosenLidar> lidars;  ///< two at least
  settings::Settings settings;
  NamedNominals nominals;
  std::string output;  ///< may be empty
  bool hashes = true;
};

/// Prints what is found and writes the file. kNoResult where a LiDAR has no usable result. Throws Error.
int calibrate_vehicle(const VehicleJob& job, Console& console);

}  // namespace remount::cli
