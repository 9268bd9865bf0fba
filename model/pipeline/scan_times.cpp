#include "model/pipeline/scan_times.h"

#include <algorithm>
#include <cmath>

#include "algorithms/cloud/deskew.h"
#include "algorithms/core/error.h"
#include "algorithms/core/median.h"
#include "algorithms/core/stamps.h"

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

double scan_period_s(const drive::ScanSource& scans) {
  constexpr std::size_t kMany = 200;
  std::vector<double> steps_s;
  for (std::size_t i = 1; i < std::min(scans.size(), kMany); ++i)
    steps_s.push_back(seconds(scans.stamp_ns(i) - scans.stamp_ns(i - 1)));
  return steps_s.empty() ? 0.0 : median_of(std::move(steps_s));
}

namespace {

motion::Sweep swept_by(const std::vector<float>& times_s) {
  motion::Sweep swept;
  bool any = false;
  for (const float time_s : times_s) {
    if (!std::isfinite(time_s)) continue;
    const double here_s = static_cast<double>(time_s);
    swept = any ? motion::Sweep{std::min(swept.from_s, here_s), std::max(swept.until_s, here_s)}
                : motion::Sweep{here_s, here_s};
    any = true;
  }
  return swept;
}

motion::Sweep usual_sweep(const drive::Session& session, settings::DeskewMode mode) {
  constexpr std::size_t kFewScans = 3;
  motion::Sweep longest;
  const bool told = session.scan_timing == drive::ScanTiming::PerPoint || sweep_of(session, mode);
  if (!told || !session.scans || mode == settings::DeskewMode::Off) return longest;
  const double most_s = 2.0 * scan_period_s(*session.scans);
  const std::size_t count = session.scans->size(), first = count / 2 - std::min(count / 2, kFewScans / 2);
  for (std::size_t i = first; i < std::min(first + kFewScans, count); ++i) {
    try {
      const motion::Sweep swept = swept_by(scan_times(session, session.scans->load(i), mode));
      if (swept.length_s() > longest.length_s() && swept.length_s() < most_s) longest = swept;
    } catch (const Error&) {
      continue;  // it is named where it is used
    }
  }
  return longest;
}

}  // namespace

std::vector<motion::Sweep> swept_times(const std::vector<std::shared_ptr<const drive::Session>>& sessions,
                                       settings::DeskewMode mode) {
  std::vector<motion::Sweep> swept;
  for (const auto& session : sessions) swept.push_back(usual_sweep(*session, mode));
  return swept;
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
