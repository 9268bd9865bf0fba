#include "model/io/pose_pairing.h"

#include <algorithm>
#include <cmath>

#include "algorithms/trajectory/clock_alignment.h"
#include "model/io/stream_tools.h"

namespace remount {

namespace {

/// Shared clocks that differ by more are not shared; the pipeline's own estimate of the time offset covers less.
constexpr double kSharedTolerance_s = 0.2;

double overlap_share(const std::vector<StampedPose>& a, const std::vector<StampedPose>& b) {
  const std::int64_t common =
      std::min(a.back().stamp_ns, b.back().stamp_ns) - std::max(a.front().stamp_ns, b.front().stamp_ns);
  const std::int64_t shorter = std::min(a.back().stamp_ns - a.front().stamp_ns, b.back().stamp_ns - b.front().stamp_ns);
  return shorter > 0 ? static_cast<double>(common) / static_cast<double>(shorter) : 0.0;
}

std::string describe(const ClockAlignment& alignment) {
  char text[160];
  std::snprintf(text, sizeof text, "INS time = LiDAR time %+.4f s (sigma %.4f s, correlation %.3f, next best %.3f)",
                alignment.offset_s, alignment.sigma_s, alignment.correlation, alignment.runner_up);
  return text;
}

}  // namespace

void align_lidar_clock(Session& session, ClockUse clocks) {
  const std::vector<StampedPose> ins = session.ins.empty() ? session.world_from_ins : rotations_of(session.ins);
  if (ins.empty() || session.odometry_from_lidar.empty()) return;
  const bool overlapping = overlap_share(ins, session.odometry_from_lidar) > 0.5;
  const ClockAlignment alignment = align_clocks(ins, session.odometry_from_lidar);
  const bool clear = alignment.found && !alignment.ambiguous;
  const bool needed = clocks == ClockUse::Unsynchronised || !overlapping;
  if (!clear) {
    if (needed)
      session.findings.push_back(
          make_finding(overlapping ? Severity::Warning : Severity::Problem, "clock-ambiguous", "clocks",
                       "The LiDAR poses cannot be brought to INS time: " + alignment.why +
                           ". Their stamps stay as they are; record a drive with several turns."));
    return;
  }
  if (!needed && std::abs(alignment.offset_s) < kSharedTolerance_s) {
    session.findings.push_back(make_finding(
        Severity::Note, "clock-offset", "clocks",
        "The two clocks agree; by the rates of rotation, " + describe(alignment) + ". Nothing was moved."));
    return;
  }
  const std::int64_t offset_ns = std::llround(alignment.offset_s * 1e9);
  for (StampedPose& pose : session.odometry_from_lidar) pose.stamp_ns += offset_ns;
  session.findings.push_back(
      make_finding(needed ? Severity::Note : Severity::Warning, "clock-aligned", "clocks",
                   "The LiDAR poses were moved to INS time by the rates of rotation: " + describe(alignment) + "."));
}

}  // namespace remount
