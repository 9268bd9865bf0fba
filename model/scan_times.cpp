#include "model/scan_times.h"

#include "algorithms/cloud/deskew.h"

namespace remount {

std::vector<float> told_times(const Session& session, const PointCloud& cloud, bool by_sweep) {
  if (cloud.points.empty()) return {};
  if (session.scan_timing == ScanTiming::PerPoint && cloud.time_from_stamp_s.size() == cloud.size())
    return cloud.time_from_stamp_s;
  if (session.scan_timing != ScanTiming::SweepAzimuth || !by_sweep) return {};
  return sweep_times(cloud, session.sweep.period_s, session.sweep.stamp_azimuth_rad, session.sweep.clockwise);
}

std::vector<float> scan_times(const Session& session, const PointCloud& cloud, DeskewMode mode) {
  if (mode == DeskewMode::Off) return {};
  return told_times(session, cloud, session.sweep.certain || mode == DeskewMode::On);
}

}  // namespace remount
