// Two logs whose clocks may not agree: LiDAR poses brought to the INS time line.
#pragma once

#include "model/drive/session.h"

namespace remount::formats {

enum class ClockUse {
  Shared,          ///< trusted where the two streams overlap; aligned where they do not
  Unsynchronised,  ///< always aligned by the rates of rotation
};

/// Moves odometry_from_lidar to the INS clock where that is needed, by correlating the rates of rotation of the two
/// streams, and says so in a finding ("clock-aligned", or "clock-ambiguous" where that is not possible and the stamps
/// stay as they are).
void align_lidar_clock(drive::Session& session, ClockUse clocks);

}  // namespace remount::formats
