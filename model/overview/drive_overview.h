// What a drive looks like from above and over time, thinned to what a screen can show.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "algorithms/core/stamps.h"
#include "model/overview/session_report.h"

namespace remount::overview {

/// The INS over a stretch of time: the worst of it.
struct InsStretch {
  double time_s = 0.0;  ///< since the start of the drive
  motion::InsQuality quality = motion::InsQuality::Unknown;
  double position_sigma_m = 0.0;    ///< largest of east, north, up; NaN where the log does not state it
  double attitude_sigma_rad = 0.0;  ///< likewise, of the three axes
  double speed_m_s = 0.0;           ///< of the INS over the stretch
};

struct TimeGap {
  double from_s = 0.0, to_s = 0.0;  ///< since the start of the drive
};

struct DriveOverview {
  bool north_up = false;      ///< x is east and y north; otherwise the axes of the pose file
  std::int64_t start_ns = 0;  ///< of whichever stream begins first
  double duration_s = 0.0;
  StreamReport lidar, ins;
  std::vector<TimeGap> lidar_gaps, ins_gaps;
  double travelled_m = 0.0;
  std::vector<Eigen::Vector2d> track_m;  ///< of the INS
  std::vector<std::size_t> breaks;       ///< places in the track before which samples are missing
  std::vector<Eigen::Vector2d> scans_m;  ///< of the INS at each scan or LiDAR pose; NaN where the INS does not cover it
  std::vector<InsStretch> stretches;
  std::vector<drive::Finding> findings;  ///< of the checks that look at the drive as a whole
  MotionOutlook outlook;                 ///< for pairs of keyframes, with the settings of the program

  double time_s(std::int64_t stamp_ns) const { return seconds(stamp_ns - start_ns); }
};

/// Reads no scan. @param most how many places of the track and stretches of time at most
DriveOverview drive_overview(const drive::Session& session, std::size_t most = 4000);

}  // namespace remount::overview
