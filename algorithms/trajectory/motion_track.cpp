#include "algorithms/trajectory/motion_track.h"

#include <algorithm>
#include <cmath>

namespace remount {
namespace {

constexpr double kSecondsPerNanosecond = 1e-9;

double seconds_between(const StampedPose& from, const StampedPose& to) {
  return static_cast<double>(to.stamp_ns - from.stamp_ns) * kSecondsPerNanosecond;
}

double default_gap_s(const std::vector<StampedPose>& samples) {
  std::vector<double> steps_s;
  for (std::size_t i = 1; i < samples.size(); ++i) steps_s.push_back(seconds_between(samples[i - 1], samples[i]));
  if (steps_s.empty()) return 0.25;
  const auto middle = steps_s.begin() + static_cast<std::ptrdiff_t>(steps_s.size() / 2);
  std::nth_element(steps_s.begin(), middle, steps_s.end());
  return std::max(0.25, 5.0 * *middle);
}

// Slope at `middle` of the parabola through three samples: second order also where steps are uneven.
Eigen::Vector3d slope(const StampedPose& before, const StampedPose& middle, const StampedPose& after) {
  const double left_s = seconds_between(before, middle), right_s = seconds_between(middle, after);
  const Eigen::Vector3d left = (middle.pose.translation() - before.pose.translation()) / left_s;
  const Eigen::Vector3d right = (after.pose.translation() - middle.pose.translation()) / right_s;
  return (left * right_s + right * left_s) / (left_s + right_s);
}

}  // namespace

MotionTrack::MotionTrack(const std::vector<StampedPose>& world_from_body, double max_gap_s) {
  samples_.reserve(world_from_body.size());
  for (const StampedPose& sample : world_from_body)
    if (samples_.empty() || sample.stamp_ns > samples_.back().stamp_ns) samples_.push_back(sample);
  max_gap_s_ = max_gap_s > 0.0 ? max_gap_s : default_gap_s(samples_);
}

std::optional<RigidTransform> MotionTrack::at(std::int64_t stamp_ns) const {
  const auto after =
      std::lower_bound(samples_.begin(), samples_.end(), stamp_ns,
                       [](const StampedPose& sample, std::int64_t stamp) { return sample.stamp_ns < stamp; });
  if (after == samples_.end()) return std::nullopt;
  if (after->stamp_ns == stamp_ns) return after->pose;
  if (after == samples_.begin()) return std::nullopt;
  const auto before = after - 1;
  const double step_s = seconds_between(*before, *after);
  if (step_s > max_gap_s_) return std::nullopt;
  const double u = static_cast<double>(stamp_ns - before->stamp_ns) * kSecondsPerNanosecond / step_s;

  const Eigen::Vector3d p0 = before->pose.translation(), p1 = after->pose.translation();
  const Eigen::Vector3d chord = (p1 - p0) / step_s;
  const bool has_left = before != samples_.begin() && seconds_between(*(before - 1), *before) <= max_gap_s_;
  const bool has_right = after + 1 != samples_.end() && seconds_between(*after, *(after + 1)) <= max_gap_s_;
  const Eigen::Vector3d v0 = has_left ? slope(*(before - 1), *before, *after) : chord;
  const Eigen::Vector3d v1 = has_right ? slope(*before, *after, *(after + 1)) : chord;
  const double u2 = u * u, u3 = u2 * u;
  const Eigen::Vector3d position =
      (2 * u3 - 3 * u2 + 1) * p0 + (u3 - 2 * u2 + u) * step_s * v0 + (-2 * u3 + 3 * u2) * p1 + (u3 - u2) * step_s * v1;
  const Eigen::Matrix3d r0 = before->pose.linear();
  const Eigen::Vector3d turn_rad = so3_log(r0.transpose() * after->pose.linear());
  return make_rigid(r0 * so3_exp(u * turn_rad), position);
}

std::optional<Vector6d> MotionTrack::body_velocity(std::int64_t stamp_ns) const {
  // A chord of 40 ms to either side averages sample noise without smoothing away a vehicle's turn.
  constexpr std::int64_t kHalfWindow_ns = 40'000'000;
  for (const auto& [back_ns, forth_ns] :
       {std::pair{kHalfWindow_ns, kHalfWindow_ns}, std::pair{std::int64_t{0}, kHalfWindow_ns},
        std::pair{kHalfWindow_ns, std::int64_t{0}}}) {
    const auto here = at(stamp_ns), from = at(stamp_ns - back_ns), to = at(stamp_ns + forth_ns);
    if (!here || !from || !to) continue;
    const double span_s = static_cast<double>(back_ns + forth_ns) * kSecondsPerNanosecond;
    Vector6d velocity;
    velocity << here->linear().transpose() * (to->translation() - from->translation()) / span_s,
        so3_log(from->linear().transpose() * to->linear()) / span_s;
    return velocity;
  }
  return std::nullopt;
}

}  // namespace remount
