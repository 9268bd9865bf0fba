// Which LiDARs of recordings are calibrated.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "app/cli/console.h"
#include "model/results/vehicle_file.h"
#include "model/rig/recorded_lidars.h"

namespace remount::cli {

using ChosenLidar = rig::RecordedLidar;

/// @param wanted "all", or names separated by commas, each as lidar_meant_by takes it
///  @param topics of every recording, other than of the LiDAR
/// All are in the order of the recordings, without what is likely no sensor, named ones as they are named. Throws
/// Error(Contract) for a name that no recording has, with those that they have.
std::vector<ChosenLidar> choose_lidars(const std::vector<std::filesystem::path>& recordings,
                                       const drive::TopicChoice& topics, const std::string& wanted, Console& console);

/// A recording with the LiDAR of that name; as it suggests it where `lidar` is empty or `topics` names one. Throws
/// Error.
drive::Session open_with_lidar(const std::filesystem::path& recording, drive::TopicChoice topics,
                               const std::string& lidar, Console& console);

/// Of a file with the results of several LiDARs that of the one that is meant by the name; nothing of another file.
/// Throws Error(Contract) where the file has several and none is named, or the other way round.
std::optional<results::LidarResult> result_of_lidar(const std::filesystem::path& path, const std::string& lidar);

}  // namespace remount::cli
