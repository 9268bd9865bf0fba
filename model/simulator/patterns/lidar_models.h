// The LiDARs that can be simulated: one list.
#pragma once

#include <memory>
#include <string_view>
#include <vector>

#include "model/simulator/patterns/scan_pattern.h"

namespace remount::simulator {

/// What a data sheet says; docs/manual/command-line.md names it. Zeros of those that options describe.
struct LidarFigures {
  double width_deg = 0.0;  ///< of the field, ahead in its middle; 360: all around
  double low_deg = 0.0, high_deg = 0.0;
  int points_per_s = 0;
  double frame_rate_hz = 0.0;
  double farthest_m = 1e6;  ///< no option makes it see farther
};

struct LidarModel {
  std::string_view id;  ///< as drives are asked for
  LidarFigures figures;
  bool spins = false;      ///< a whole turn a frame, stamped in its middle; others are stamped when a frame begins
  bool has_rings = false;  ///< channels are rings, of one elevation each
  std::unique_ptr<ScanPattern> (*make)(const PatternSettings& settings) = nullptr;
};

/// Where a model stands in the list; the first is the usual one.
enum class LidarChoice : int {};

const std::vector<LidarModel>& lidar_models();
const std::vector<std::string_view>& lidar_model_names();
const LidarModel& lidar_model(LidarChoice choice);
/// Throws Error(Contract) where there is none of that name.
LidarChoice lidar_named(std::string_view id);

}  // namespace remount::simulator
