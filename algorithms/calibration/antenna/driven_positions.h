// Positions of an antenna with what wheels and rates say of the way between them, cut into windows.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "algorithms/core/progress.h"
#include "algorithms/motion/wheel_integration.h"

namespace remount::calibration {

struct StampedPosition {
  std::int64_t stamp_ns = 0;
  Eigen::Vector3d position_m = Eigen::Vector3d::Zero();  ///< level metric frame, z up
};

/// A position that wheels and rates cover.
struct DrivenPosition {
  std::size_t window = 0;
  bool begins_window = false;
  double time_s = 0.0;                    ///< since the start of the window
  std::vector<motion::MotionStep> steps;  ///< since the position before, also where a window begins; none after a gap
  StampedPosition position;
};

/// A new window after `window_s` and after each gap of the sensed. Cancelled: fewer.
std::vector<DrivenPosition> driven_positions(const motion::WheelImuSignals& sensed,
                                             const std::vector<StampedPosition>& positions, double window_s,
                                             const Progress& progress);

}  // namespace remount::calibration
