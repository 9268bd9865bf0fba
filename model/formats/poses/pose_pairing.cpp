#include "model/formats/poses/pose_pairing.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "algorithms/motion/clock_alignment.h"
#include "messages/places.h"
#include "messages/poses.h"
#include "model/conventions/week_rollover.h"
#include "model/drive/bad_items.h"
#include "model/formats/files/time_stamp.h"

namespace remount::formats {

namespace {

/// Shared clocks that differ by more are not shared; the pipeline's own estimate of the time offset covers less.
constexpr double kSharedTolerance_s = 0.2;
constexpr double kAgreeing_s = 0.01;  ///< of clocks that are declared unsynchronised

double overlap_share(const motion::RotationStream& a, const motion::RotationStream& b) {
  const std::int64_t a_begin = a.stamp_ns(0), a_end = a.stamp_ns(a.size() - 1);
  const std::int64_t b_begin = b.stamp_ns(0), b_end = b.stamp_ns(b.size() - 1);
  const std::int64_t common = std::min(a_end, b_end) - std::max(a_begin, b_begin);
  const std::int64_t shorter = std::min(a_end - a_begin, b_end - b_begin);
  return shorter > 0 ? static_cast<double>(common) / static_cast<double>(shorter) : 0.0;
}

Message describe(const motion::ClockAlignment& alignment) {
  return say::clock_by_rates(Duration{alignment.offset_s}, Duration{alignment.sigma_s}, alignment.correlation,
                             alignment.runner_up);
}

/// Whether differences of their times can be told in nanoseconds.
bool are_comparable(const motion::RotationStream& a, const motion::RotationStream& b) {
  const auto [first_ns, last_ns] =
      std::minmax({a.stamp_ns(0), a.stamp_ns(a.size() - 1), b.stamp_ns(0), b.stamp_ns(b.size() - 1)});
  constexpr double kMost_ns = 4e18;
  return is_stamp(first_ns) && is_stamp(last_ns) &&
         static_cast<double>(last_ns) - static_cast<double>(first_ns) < kMost_ns;
}

/// False, and nothing is moved, where times would be beyond those that there are.
bool move_stamps(std::vector<motion::StampedPose>& poses, std::int64_t by_ns) {
  for (const motion::StampedPose& pose : poses)
    if (!moved_ns(pose.stamp_ns, by_ns)) return false;
  for (motion::StampedPose& pose : poses) pose.stamp_ns += by_ns;
  return true;
}

void report_not_aligned(Message why, std::vector<drive::Finding>& findings) {
  findings.push_back(drive::make_finding(drive::Severity::Problem, "clock-ambiguous", say::place_clocks(),
                                         say::clock_not_aligned(std::move(why))));
}

}  // namespace

void align_lidar_clock(drive::Session& session, ClockUse clocks) {
  conventions::mend_week_rollover(session);
  const motion::RotationStream ins =
      session.ins.empty() ? motion::RotationStream(session.world_from_ins) : motion::RotationStream(session.ins);
  if (ins.empty() || session.odometry_from_lidar.empty()) return;
  if (!are_comparable(ins, motion::RotationStream(session.odometry_from_lidar)))
    return report_not_aligned(say::clock_times_too_far_apart(), session.findings);
  const bool overlapping = overlap_share(ins, session.odometry_from_lidar) > 0.5;
  const motion::ClockAlignment alignment = motion::align_clocks(ins, session.odometry_from_lidar);
  const bool clear = alignment.found && !alignment.ambiguous;
  const bool needed = clocks == ClockUse::Unsynchronised || !overlapping;
  if (!clear) {
    if (needed && !overlapping) report_not_aligned(alignment.why, session.findings);
    if (needed && overlapping)
      session.findings.push_back(drive::make_finding(drive::Severity::Warning, "clock-ambiguous", say::place_clocks(),
                                                     say::clock_not_told(alignment.why)));
    return;
  }
  // Moving by what may be chance makes clocks worse that agree; a coarse estimate does not show that they do.
  const double tolerance_s = needed ? std::min(2.0 * alignment.sigma_s, kAgreeing_s) : kSharedTolerance_s;
  if (overlapping && std::abs(alignment.offset_s) < tolerance_s) {
    session.findings.push_back(drive::make_finding(drive::Severity::Note, "clock-offset", say::place_clocks(),
                                                   say::clock_agrees(describe(alignment))));
    return;
  }
  if (!move_stamps(session.odometry_from_lidar, std::llround(alignment.offset_s * 1e9)))
    return report_not_aligned(say::clock_times_too_far_apart(), session.findings);
  session.findings.push_back(drive::make_finding(needed ? drive::Severity::Note : drive::Severity::Warning,
                                                 "clock-aligned", say::place_clocks(),
                                                 say::clock_moved(describe(alignment))));
}

}  // namespace remount::formats
