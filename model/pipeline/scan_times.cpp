#include "model/pipeline/scan_times.h"

#include <algorithm>

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

motion::Sweep usual_sweep(const drive::Session& session, const std::optional<drive::SweepModel>& sweep) {
  constexpr std::size_t kFew = 3;
  motion::Sweep longest;
  if (!session.scans || (session.scan_timing != drive::ScanTiming::PerPoint && !sweep)) return longest;
  const std::size_t count = session.scans->size(), first = count / 2 - std::min(count / 2, kFew / 2);
  for (std::size_t i = first; i < std::min(first + kFew, count); ++i) {
    try {
      const std::vector<float> times_s = told_times(session, session.scans->load(i), sweep);
      if (times_s.empty()) continue;
      const auto [begin_s, end_s] = std::ranges::minmax(times_s);
      if (end_s - begin_s > longest.length_s()) longest = {begin_s, end_s};
    } catch (const Error&) {
      continue;  // it is named where it is used
    }
  }
  return longest;
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
