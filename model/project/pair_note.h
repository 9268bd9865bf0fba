// What somebody noted about a pair while looking at it.
#pragma once

#include <cstdint>
#include <string>

#include "algorithms/motion/pair.h"

namespace remount::project {

/// Named by what outlives a calibration: recording, LiDAR and the stamps of the two scans.
struct PairNote {
  motion::SessionIndex session;
  std::string lidar;  ///< the topic, or the LiDAR of the recording; empty where it has one
  std::int64_t stamp_a_ns = 0, stamp_b_ns = 0;
  bool seen = false, flagged = false;
  std::string comment;
};

}  // namespace remount::project
