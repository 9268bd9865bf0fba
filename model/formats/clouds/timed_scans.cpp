#include "model/formats/clouds/timed_scans.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "messages/sessions.h"
#include "model/drive/bad_items.h"
#include "model/formats/clouds/cloud_fields.h"
#include "model/formats/clouds/sweep_misfit.h"

namespace remount::formats {

const drive::ScanFile& FileScanSource::at(std::size_t scan) const {
  if (scan >= files_.size()) throw Error(ErrorCode::Contract, "", say::scans_no_such(scan, files_.size()));
  return files_[scan];
}

bool has_point_times(const cloud::PointCloud& cloud) {
  constexpr float kLeast_s = 1e-3f;
  constexpr std::size_t kManyPoints = 256, kFewest = 8;  // points, and different times of so many
  const std::vector<float>& times_s = cloud.time_from_stamp_s;
  if (times_s.empty()) return false;
  const auto [low, high] = std::minmax_element(times_s.begin(), times_s.end());
  if (!(*high - *low > kLeast_s)) return false;
  std::set<float> different;
  for (std::size_t i = 0; i < times_s.size() && different.size() < kFewest; ++i) different.insert(times_s[i]);
  return times_s.size() < kManyPoints || different.size() >= kFewest;
}

cloud::PointCloud TimedScanSource::load(std::size_t scan) const {
  cloud::PointCloud cloud = read(scan).cloud;
  // A column or two of a sweep may be all that a torn scan has.
  constexpr std::size_t kManyPoints = 256;
  const bool untimed = cloud.time_from_stamp_s.empty() || (cloud.size() >= kManyPoints && !has_point_times(cloud));
  if (times_ == TimesOfPoints::Required && !cloud.points.empty() && untimed)
    throw Error(ErrorCode::Format, name(scan), say::scans_one_untimed());
  return cloud;
}

namespace {

double scan_interval_s(const TimedScanSource& scans) {
  constexpr std::size_t kMost = 500;
  std::vector<std::int64_t> steps;
  for (std::size_t i = 1; i < std::min(scans.size(), kMost); ++i)
    steps.push_back(scans.stamp_ns(i) - scans.stamp_ns(i - 1));
  if (steps.empty()) return 0.0;
  return seconds(median_of(std::move(steps)));
}

Message no_times_words(const ReadCloud& read) {
  return read.cloud.time_from_stamp_s.empty() ? say::times_none(read.columns_words())
                                              : say::times_all_the_same(read.columns_words());
}

}  // namespace

FoundPointTimes find_point_times(const TimedScanSource& scans) {
  FoundPointTimes found;
  const double interval_s = scan_interval_s(scans);
  for (std::size_t i = 0; i < std::min<std::size_t>(scans.size(), 3) && !found.usable; ++i) {
    try {
      const ReadCloud read = scans.read(i);
      const Message coarse = coarse_times(read);
      const bool timed = coarse.empty() && has_point_times(read.cloud);
      const Message misfit = timed ? sweep_misfit(read, interval_s) : Message();
      found.usable = timed && misfit.empty();
      if (found.usable) found.count = times_count(read.cloud);
      if (found.misfit || read.cloud.points.empty() || (!found.scan.empty() && misfit.empty())) continue;
      found.scan = scans.name(i);
      found.misfit = !misfit.empty();
      found.problem = found.misfit ? misfit : !coarse.empty() ? coarse : no_times_words(read);
    } catch (const Error&) {
      continue;  // becomes known when the scan is used
    }
  }
  found.misfit = found.misfit && !found.usable;
  return found;
}

Message expected_time_columns() { return say::times_known_columns({std::begin(kTimeColumns), std::end(kTimeColumns)}); }

namespace {

void report_unusable_times(const FoundPointTimes& found, TimedScanSource& scans, drive::Session& session) {
  session.scan_timing = drive::ScanTiming::Unknown;
  scans.use_times(TimesOfPoints::Unused);
  if (found.misfit) {
    session.findings.push_back(drive::make_finding(drive::Severity::Warning, "point-times-misfit", found.scan,
                                                   say::times_of_no_sweep(found.problem)));
    return;
  }
  session.findings.push_back(
      drive::make_finding(drive::Severity::Warning, "no-point-times", found.scan.empty() ? scans.name(0) : found.scan,
                          say::times_not_known(found.problem.empty() ? say::times_no_scan_readable() : found.problem)));
}

}  // namespace

void report_no_point_times(TimedScanSource& scans, drive::Session& session) {
  report_unusable_times(find_point_times(scans), scans, session);
}

void use_point_times(TimedScanSource& scans, drive::Session& session) {
  const FoundPointTimes found = find_point_times(scans);
  if (!found.usable) return report_unusable_times(found, scans, session);
  session.scan_timing = drive::ScanTiming::PerPoint;
  session.times_count = found.count;
  scans.use_times(TimesOfPoints::Required);
  report_point_clock(scans, session.findings);
}

void report_point_clock(const TimedScanSource& scans, std::vector<drive::Finding>& findings) {
  for (std::size_t i = 0; i < std::min<std::size_t>(scans.size(), 3); ++i) try {
      if (scans.read(i).points_have_another_clock)
        findings.push_back(
            drive::make_finding(drive::Severity::Warning, "point-clock", scans.name(i), say::times_another_clock()));
      return;
    } catch (const Error&) {
      continue;  // becomes known when the scan is used
    }
}

}  // namespace remount::formats
