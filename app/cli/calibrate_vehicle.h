// Several LiDARs of a vehicle in one calibration.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "app/cli/lidar_choice.h"
#include "app/cli/named_measured.h"
#include "app/cli/named_nominals.h"
#include "model/results/input_files.h"
#include "model/rig/rig_calibration.h"
#include "model/settings/settings.h"

namespace remount::cli {

struct VehicleJob {
  std::vector<std::filesystem::path> recordings;
  std::vector<ChosenLidar> lidars;
  settings::Settings settings;
  NamedNominals nominals;
  NamedMeasured measured;
  std::string output;  ///< may be empty
  bool hashes = true;
};

/// What is calibrated of each LiDAR, with its sessions and its nominal. Throws Error.
std::vector<rig::LidarJob> open_lidars(const VehicleJob& job, Console& console);

/// Whether Ctrl-C came before the LiDARs were solved together, which each of them may have a usable result without.
bool was_cancelled(const rig::RigOutput& output, const Console& console);

/// Prints what is found and writes the file where `path` is not empty. kNoResult where a LiDAR has no usable result.
int finish_vehicle(const std::vector<rig::LidarJob>& lidars, const rig::RigOutput& output,
                   std::vector<std::vector<results::InputFile>> inputs, const std::string& path, Console& console);

/// All of it. Throws Error.
int calibrate_vehicle(const VehicleJob& job, Console& console);

}  // namespace remount::cli
