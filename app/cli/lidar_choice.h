// Which LiDARs of recordings are calibrated, and how each recording is opened with them.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "app/cli/console.h"
#include "model/drive/lidar_offer.h"
#include "model/drive/session.h"
#include "model/drive/topic_choice.h"

namespace remount::cli {

struct ChosenLidar {
  struct Recording {
    std::size_t place;  ///< among all recordings
    drive::TopicChoice topics;
  };
  std::string name;
  std::vector<Recording> recordings;  ///< those that have it, at least one
};

/// @param wanted "all", or names separated by commas @param topics of every recording, other than of the LiDAR
/// All are in the order of the recordings, without what is likely no sensor, named ones as they are named. Throws
/// Error(Contract) for a name that no recording has, with those that they have.
std::vector<ChosenLidar> choose_lidars(const std::vector<std::filesystem::path>& recordings,
                                       const drive::TopicChoice& topics, const std::string& wanted, Console& console);

/// The LiDARs of a session's recording where it has several; nothing where not, or where they cannot be listed.
std::vector<drive::LidarOffer> lidars_of_several(const drive::Session& session, Progress& progress);

}  // namespace remount::cli
