#include "model/formats/poses/pose_pairing.h"

#include <algorithm>
#include <cmath>

#include "algorithms/motion/clock_alignment.h"
#include "messages/places.h"
#include "messages/poses.h"
#include "model/conventions/week_rollover.h"
#include "model/drive/bad_items.h"

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

}  // namespace

void align_lidar_clock(drive::Session& session, ClockUse clocks) {
  conventions::mend_week_rollover(session);
  const motion::RotationStream ins =
      session.ins.empty() ? motion::RotationStream(session.world_from_ins) : motion::RotationStream(session.ins);
  if (ins.empty() || session.odometry_from_lidar.empty()) return;
  const bool overlapping = overlap_share(ins, session.odometry_from_lidar) > 0.5;
  const motion::ClockAlignment alignment = motion::align_clocks(ins, session.odometry_from_lidar);
  const bool clear = alignment.found && !alignment.ambiguous;
  const bool needed = clocks == ClockUse::Unsynchronised || !overlapping;
  if (!clear) {
    if (needed)
      session.findings.push_back(overlapping
                                     ? drive::make_finding(drive::Severity::Warning, "clock-ambiguous",
                                                           say::place_clocks(), say::clock_not_told(alignment.why))
                                     : drive::make_finding(drive::Severity::Problem, "clock-ambiguous",
                                                           say::place_clocks(), say::clock_not_aligned(alignment.why)));
    return;
  }
  // Moving by what may be chance makes clocks worse that agree; a coarse estimate does not show that they do.
  const double tolerance_s = needed ? std::min(2.0 * alignment.sigma_s, kAgreeing_s) : kSharedTolerance_s;
  if (overlapping && std::abs(alignment.offset_s) < tolerance_s) {
    session.findings.push_back(drive::make_finding(drive::Severity::Note, "clock-offset", say::place_clocks(),
                                                   say::clock_agrees(describe(alignment))));
    return;
  }
  const std::int64_t offset_ns = std::llround(alignment.offset_s * 1e9);
  for (motion::StampedPose& pose : session.odometry_from_lidar) pose.stamp_ns += offset_ns;
  session.findings.push_back(drive::make_finding(needed ? drive::Severity::Note : drive::Severity::Warning,
                                                 "clock-aligned", say::place_clocks(),
                                                 say::clock_moved(describe(alignment))));
}

}  // namespace remount::formats
