#include "model/overview/drive_overview.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "algorithms/core/stamps.h"
#include "model/checks/data_check.h"
#include "model/drive/session_frames.h"

namespace remount::overview {
namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
constexpr double kGapSteps = 3.0;  // as report_stream counts gaps

std::vector<TimeGap> gaps_of(const std::vector<std::int64_t>& stamps_ns, const StreamReport& report,
                             const DriveOverview& drive) {
  std::vector<TimeGap> gaps;
  if (report.gaps == 0 || !(report.rate_hz > 0.0)) return gaps;
  for (std::size_t i = 1; i < stamps_ns.size(); ++i)
    if (seconds(stamps_ns[i] - stamps_ns[i - 1]) > kGapSteps / report.rate_hz)
      gaps.push_back({drive.time_s(stamps_ns[i - 1]), drive.time_s(stamps_ns[i])});
  return gaps;
}

Eigen::Vector2d place_at(const std::vector<motion::StampedPose>& poses, std::int64_t stamp_ns) {
  const auto after =
      std::lower_bound(poses.begin(), poses.end(), stamp_ns,
                       [](const motion::StampedPose& pose, std::int64_t stamp) { return pose.stamp_ns < stamp; });
  if (after == poses.end() || (after == poses.begin() && after->stamp_ns != stamp_ns)) return {kNone, kNone};
  if (after->stamp_ns == stamp_ns) return after->pose.translation().head<2>();
  const auto before = after - 1;
  const double share =
      static_cast<double>(stamp_ns - before->stamp_ns) / static_cast<double>(after->stamp_ns - before->stamp_ns);
  return (1.0 - share) * before->pose.translation().head<2>() + share * after->pose.translation().head<2>();
}

/// Worse counts more: a fix that is not usable is not to be hidden by good ones beside it.
int badness(motion::InsQuality quality) {
  switch (quality) {
    case motion::InsQuality::Good:
      return 1;
    case motion::InsQuality::Degraded:
      return 2;
    case motion::InsQuality::Invalid:
      return 3;
    case motion::InsQuality::Unknown:
      break;
  }
  return 0;
}

void take_worst(const motion::InsSample& sample, InsStretch& stretch) {
  if (badness(sample.quality) > badness(stretch.quality)) stretch.quality = sample.quality;
  const double position = sample.sigma.position_enu_m.maxCoeff(), attitude = sample.sigma.attitude_rad.maxCoeff();
  if (!(stretch.position_sigma_m >= position) && std::isfinite(position)) stretch.position_sigma_m = position;
  if (!(stretch.attitude_sigma_rad >= attitude) && std::isfinite(attitude)) stretch.attitude_sigma_rad = attitude;
}

/// Over a quarter of a second to each side: from sample to sample, noise of the fixes would pass for speed.
double speed_m_s(const std::vector<motion::StampedPose>& poses, std::size_t i) {
  constexpr std::int64_t kReach_ns = 250'000'000;
  std::size_t first = i, last = i;
  while (first > 0 && poses[i].stamp_ns - poses[first].stamp_ns < kReach_ns) --first;
  while (last + 1 < poses.size() && poses[last].stamp_ns - poses[i].stamp_ns < kReach_ns) ++last;
  const double taken_s = seconds(poses[last].stamp_ns - poses[first].stamp_ns);
  return taken_s > 0.0 ? (poses[last].pose.translation() - poses[first].pose.translation()).norm() / taken_s : 0.0;
}

void describe_track(const drive::Session& session, const std::vector<motion::StampedPose>& poses, std::size_t most,
                    DriveOverview& drive) {
  const std::size_t every = std::max<std::size_t>(1, (poses.size() + most - 1) / most);
  const double longest_s = drive.ins.rate_hz > 0.0 ? kGapSteps / drive.ins.rate_hz : 0.0;
  bool broken = false;
  for (std::size_t i = 0; i < poses.size(); ++i) {
    if (i > 0) {
      drive.travelled_m += (poses[i].pose.translation() - poses[i - 1].pose.translation()).norm();
      broken |= seconds(poses[i].stamp_ns - poses[i - 1].stamp_ns) > longest_s;
    }
    if (i % every == 0) {
      drive.stretches.push_back({drive.time_s(poses[i].stamp_ns), motion::InsQuality::Unknown, kNone, kNone, 0.0});
      drive.stretches.back().speed_m_s = speed_m_s(poses, i);
    }
    if (i < session.ins.size()) take_worst(session.ins[i], drive.stretches.back());
    if (i % every != 0 && i + 1 != poses.size() && !broken) continue;
    if (broken) drive.breaks.push_back(drive.track_m.size());
    broken = false;
    drive.track_m.emplace_back(poses[i].pose.translation().head<2>());
  }
}

}  // namespace

DriveOverview drive_overview(const drive::Session& session, std::size_t most) {
  DriveOverview drive;
  drive.north_up = !session.ins.empty();
  const std::vector<motion::StampedPose> poses = drive::metric_poses(session);
  const std::vector<std::int64_t> lidar = lidar_stamps_ns(session);
  std::vector<std::int64_t> ins;
  for (const motion::StampedPose& pose : poses) ins.push_back(pose.stamp_ns);
  drive.lidar = report_stream(lidar);
  drive.ins = report_stream(ins);
  std::int64_t last_ns = std::numeric_limits<std::int64_t>::min();
  drive.start_ns = std::numeric_limits<std::int64_t>::max();
  for (const StreamReport* stream : {&drive.lidar, &drive.ins}) {
    if (stream->count == 0) continue;
    drive.start_ns = std::min(drive.start_ns, stream->first_ns);
    last_ns = std::max(last_ns, stream->last_ns);
  }
  if (drive.lidar.count + drive.ins.count == 0) drive.start_ns = last_ns = 0;
  drive.duration_s = drive.time_s(last_ns);
  drive.lidar_gaps = gaps_of(lidar, drive.lidar, drive);
  drive.ins_gaps = gaps_of(ins, drive.ins, drive);
  describe_track(session, poses, most, drive);
  for (const std::int64_t stamp_ns : lidar) drive.scans_m.push_back(place_at(poses, stamp_ns));
  drive.findings = checks::drive_findings(session);
  drive.outlook = motion_outlook(session);
  return drive;
}

}  // namespace remount::overview
