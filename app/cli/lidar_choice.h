// Which LiDARs of recordings are calibrated.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "app/cli/console.h"
#include "model/rig/recorded_lidars.h"

namespace remount::cli {

using ChosenLidar = rig::RecordedLidar;

/// @param wanted "all", or names separated by commas @param topics of every recording, other than of the LiDAR
/// All are in the order of the recordings, without what is likely no sensor, named ones as they are named. Throws
/// Error(Contract) for a name that no recording has, with those that they have.
std::vector<ChosenLidar> choose_lidars(const std::vector<std::filesystem::path>& recordings,
                                       const drive::TopicChoice& topics, const std::string& wanted, Console& console);

}  // namespace remount::cli
