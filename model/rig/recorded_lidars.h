// Which LiDARs recordings hold, and how each recording is opened with one of them.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "algorithms/core/progress.h"
#include "model/drive/lidar_offer.h"
#include "model/drive/session.h"
#include "model/drive/topic_choice.h"

namespace remount::rig {

struct RecordedLidar {
  struct Recording {
    std::size_t place;  ///< among all recordings
    drive::TopicChoice topics;
  };
  std::string name;
  std::vector<Recording> recordings;  ///< those that have it, at least one
};

struct RecordedLidars {
  std::vector<RecordedLidar> all;      ///< in the order of the recordings
  std::vector<RecordedLidar> sensors;  ///< without what is likely none; all where there is nothing else
};

/// By their names. @param topics of every recording, other than of the LiDAR
RecordedLidars find_lidars(const std::vector<std::filesystem::path>& recordings, const drive::TopicChoice& topics,
                           Progress& progress);

/// The LiDARs of a session's recording where it has several; nothing where not, or where they cannot be listed.
std::vector<drive::LidarOffer> lidars_of_several(const drive::Session& session, Progress& progress);

}  // namespace remount::rig
