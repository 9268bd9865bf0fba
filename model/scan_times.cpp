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

std::string scan_name_at(const ScanSource& scans, std::int64_t stamp_ns) {
  std::size_t first = 0, last = scans.size();  // [first, last)
  while (last - first > 1) {
    const std::size_t middle = first + (last - first) / 2;
    (scans.stamp_ns(middle) <= stamp_ns ? first : last) = middle;
  }
  return scans.name(first);
}

}  // namespace remount
