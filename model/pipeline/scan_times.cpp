#include "model/pipeline/scan_times.h"

#include <algorithm>
#include <cmath>

#include "algorithms/cloud/deskew.h"
#include "algorithms/core/error.h"

namespace remount::pipeline {

namespace {

/// Of points in the order in which they were measured; the stamp is in the middle of them.
std::vector<float> times_by_order(std::size_t points, double period_s) {
  std::vector<float> times_s(points);
  for (std::size_t i = 0; i < points; ++i)
    times_s[i] = static_cast<float>(period_s * ((static_cast<double>(i) + 0.5) / static_cast<double>(points) - 0.5));
  return times_s;
}

std::vector<float> times_forward(std::vector<float> times_s, drive::TimesCount count) {
  if (count == drive::TimesCount::Backwards)
    for (float& time_s : times_s) time_s = -time_s;
  return times_s;
}

}  // namespace

std::vector<float> told_times(const drive::Session& session, const cloud::PointCloud& cloud,
                              const std::optional<drive::SweepModel>& sweep) {
  if (cloud.points.empty()) return {};
  const bool timed = cloud.time_from_stamp_s.size() == cloud.size();
  if (session.scan_timing == drive::ScanTiming::PerPoint && timed)
    return times_forward(cloud.time_from_stamp_s, session.times_count);
  if (!sweep) return {};
  if (sweep->by_times) return timed ? times_forward(cloud.time_from_stamp_s, *sweep->by_times) : std::vector<float>{};
  if (sweep->by_order) return times_by_order(cloud.size(), sweep->period_s);
  return cloud::sweep_times(cloud, sweep->period_s, sweep->stamp_azimuth_rad, sweep->clockwise);
}

std::optional<drive::SweepModel> sweep_of(const drive::Session& session, settings::DeskewMode mode) {
  if (session.scan_timing != drive::ScanTiming::SweepAzimuth || mode == settings::DeskewMode::Off) return std::nullopt;
  if (!session.sweep.certain && mode != settings::DeskewMode::On) return std::nullopt;
  return session.sweep;
}

std::vector<float> scan_times(const drive::Session& session, const cloud::PointCloud& cloud,
                              settings::DeskewMode mode) {
  if (mode == settings::DeskewMode::Off) return {};
  return told_times(session, cloud, sweep_of(session, mode));
}

double middle_of_sweeps_s(const drive::Session& session) {
  constexpr double kMost_s = 0.1;  // the stamp stays within what the motion about the middle is known of
  const bool told = session.scan_timing == drive::ScanTiming::PerPoint || sweep_of(session, settings::DeskewMode::Auto);
  if (!told || !session.scans || session.scans->size() == 0) return 0.0;
  try {
    const std::vector<float> times_s =
        scan_times(session, session.scans->load(session.scans->size() / 2), settings::DeskewMode::Auto);
    if (times_s.empty()) return 0.0;
    const auto [begin_s, end_s] = std::ranges::minmax(times_s);
    const double middle_s = 0.5 * (static_cast<double>(begin_s) + static_cast<double>(end_s));
    return std::isfinite(middle_s) ? std::clamp(middle_s, -kMost_s, kMost_s) : 0.0;
  } catch (const Error&) {
    return 0.0;  // it is named where it is used
  }
}

bool tells_clock(const drive::Session& session, settings::DeskewMode mode) {
  if (!session.scans || (session.scan_timing == drive::ScanTiming::Instant && !session.scan_timing_open)) return true;
  if (mode == settings::DeskewMode::Off || session.scan_timing_open) return false;
  return session.scan_timing == drive::ScanTiming::PerPoint || sweep_of(session, mode).has_value();
}

std::string scan_name_at(const drive::ScanSource& scans, std::int64_t stamp_ns) {
  std::size_t first = 0, last = scans.size();  // [first, last)
  while (last - first > 1) {
    const std::size_t middle = first + (last - first) / 2;
    (scans.stamp_ns(middle) <= stamp_ns ? first : last) = middle;
  }
  return scans.name(first);
}

}  // namespace remount::pipeline
