#include "algorithms/motion/keyframes.h"

#include <algorithm>
#include <cmath>

#include "algorithms/core/stamps.h"

namespace remount::motion {

namespace {

std::vector<Keyframe> select_spaced(SessionIndex session, const std::vector<std::int64_t>& scan_stamps_ns,
                                    const MotionTrack& track, std::int64_t offset_ns, const KeyframeOptions& options,
                                    GatheredFrames frames) {
  std::vector<Keyframe> chosen;
  std::optional<RigidTransform> previous_scan, last_chosen;
  double travelled_m = 0.0;
  for (ScanIndex scan; scan < scan_stamps_ns.size(); ++scan) {
    const auto pose = track.at(scan_stamps_ns[scan] + offset_ns);
    if (!pose) continue;
    if (previous_scan) travelled_m += (pose->translation() - previous_scan->translation()).norm();
    previous_scan = pose;
    bool take = chosen.empty();
    if (!take && options.mode == KeyframeMode::Time) {
      // Half a millisecond of tolerance: stamps of a steady sensor jitter around the interval.
      take = seconds(scan_stamps_ns[scan] - chosen.back().stamp_ns) >= options.interval_s - 5e-4;
    } else if (!take) {
      take = travelled_m - chosen.back().travelled_m >= options.distance_m ||
             rotation_angle_between_rad(*last_chosen, *pose) >= degrees_to_radians(options.rotation_deg);
    }
    const bool has_own = scan >= frames.before() && scan + frames.after() < scan_stamps_ns.size() &&
                         (chosen.empty() || scan >= chosen.back().scan + frames.count);
    if (!take || !has_own) continue;
    chosen.push_back({session, scan, scan_stamps_ns[scan], travelled_m});
    last_chosen = pose;
  }
  return chosen;
}

// How far the vehicle turns between the first of `count` keyframes and the one that is turned most.
double turn_within_rad(const std::vector<RigidTransform>& poses, std::size_t first, std::size_t count) {
  double most_rad = 0.0;
  for (std::size_t i = first + 1; i < first + count; ++i)
    most_rad = std::max(most_rad, rotation_angle_between_rad(poses[first], poses[i]));
  return most_rad;
}

// A stretch of neighbours of each of equal parts: keyframes that are spread one by one see nothing in common. That
// which turns most tells most.
std::vector<Keyframe> spread_stretches(const std::vector<Keyframe>& all, const MotionTrack& track,
                                       std::int64_t offset_ns, std::size_t count) {
  constexpr std::size_t kStretch = 20;
  std::vector<RigidTransform> poses;
  for (const Keyframe& keyframe : all)
    poses.push_back(track.at(keyframe.stamp_ns + offset_ns).value_or(RigidTransform::Identity()));
  const std::size_t stretches = (count + kStretch - 1) / kStretch;
  std::vector<Keyframe> spread;
  for (std::size_t s = 0; s < stretches; ++s) {
    const std::size_t end = all.size() * (s + 1) / stretches;
    std::size_t best = all.size() * s / stretches;
    const std::size_t length = std::min(count * (s + 1) / stretches - count * s / stretches, end - best);
    for (std::size_t first = best + 1; first + length <= end; ++first)
      if (turn_within_rad(poses, first, length) > turn_within_rad(poses, best, length)) best = first;
    spread.insert(spread.end(), all.begin() + std::ptrdiff_t(best), all.begin() + std::ptrdiff_t(best + length));
  }
  return spread;
}

}  // namespace

std::vector<Keyframe> select_keyframes(SessionIndex session, const std::vector<std::int64_t>& scan_stamps_ns,
                                       const MotionTrack& track, double offset_s, const KeyframeOptions& options,
                                       GatheredFrames frames) {
  const auto offset_ns = static_cast<std::int64_t>(std::llround(offset_s * 1e9));
  std::vector<Keyframe> chosen = select_spaced(session, scan_stamps_ns, track, offset_ns, options, frames);
  const std::size_t enough = std::min(static_cast<std::size_t>(options.minimum), scan_stamps_ns.size() / frames.count);
  KeyframeOptions closer = options;
  for (int round = 0; round < 8 && chosen.size() < enough; ++round) {
    closer.distance_m *= 0.5;
    closer.rotation_deg *= 0.5;
    closer.interval_s *= 0.5;
    chosen = select_spaced(session, scan_stamps_ns, track, offset_ns, closer, frames);
  }
  const auto maximum = static_cast<std::size_t>(options.maximum);
  return chosen.size() <= maximum ? chosen : spread_stretches(chosen, track, offset_ns, maximum);
}

}  // namespace remount::motion
