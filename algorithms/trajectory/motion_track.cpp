#include "algorithms/trajectory/motion_track.h"

#include <Eigen/Cholesky>
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

constexpr double kHalfWindow_s = 0.1;  // twice the time from the stamp of a 10 Hz sweep to its ends
constexpr std::size_t kFewestInWindow = 11;

// Weights of the least-squares parabola through values at some times: row 0 gives the value at time zero, row 1 the
// slope, row 2 half the curvature.
Eigen::Matrix3Xd parabola_weights(const std::vector<double>& times_s) {
  Eigen::Matrix3Xd powers(3, static_cast<Eigen::Index>(times_s.size()));
  for (std::size_t i = 0; i < times_s.size(); ++i)
    powers.col(static_cast<Eigen::Index>(i)) << 1.0, times_s[i] / kHalfWindow_s,
        times_s[i] * times_s[i] / (kHalfWindow_s * kHalfWindow_s);
  const Eigen::Matrix3d normal = powers * powers.transpose();
  Eigen::Matrix3Xd weights = normal.ldlt().solve(powers);
  weights.row(1) /= kHalfWindow_s;
  weights.row(2) /= kHalfWindow_s * kHalfWindow_s;
  return weights;
}

double median(std::vector<double>& values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

}  // namespace

struct MotionTrack::Window {
  std::size_t first = 0, count = 0;
  std::vector<double> times_s;  // from the stamp
};

MotionTrack::MotionTrack(const std::vector<StampedPose>& world_from_body, double max_gap_s) {
  samples_.reserve(world_from_body.size());
  for (const StampedPose& sample : world_from_body)
    if (samples_.empty() || sample.stamp_ns > samples_.back().stamp_ns) samples_.push_back(sample);
  max_gap_s_ = max_gap_s > 0.0 ? max_gap_s : default_gap_s(samples_);
  choose_smoothing();
}

// Samples within the window that no gap separates from the stamp.
MotionTrack::Window MotionTrack::window(std::int64_t stamp_ns) const {
  const auto from = [&](std::size_t i) {
    return static_cast<double>(samples_[i].stamp_ns - stamp_ns) * kSecondsPerNanosecond;
  };
  const auto here = static_cast<std::size_t>(
      std::lower_bound(samples_.begin(), samples_.end(), stamp_ns,
                       [](const StampedPose& sample, std::int64_t stamp) { return sample.stamp_ns < stamp; }) -
      samples_.begin());
  const auto joined = [&](std::size_t left) {
    return seconds_between(samples_[left], samples_[left + 1]) <= max_gap_s_;
  };
  constexpr double kEdge_s = kHalfWindow_s + 1e-6;
  Window out;
  std::size_t first = here, last = here;  // [first, last)
  while (last < samples_.size() && from(last) <= kEdge_s && (last == here || joined(last - 1))) ++last;
  while (first > 0 && from(first - 1) >= -kEdge_s && (first == samples_.size() || joined(first - 1))) --first;
  out.first = first;
  out.count = last - first;
  for (std::size_t i = first; i < last; ++i) out.times_s.push_back(from(i));
  return out;
}

// White noise shows in third differences (variance 20 sigma^2), smooth motion hardly does. Where a parabola leaves no
// more than that noise, it loses nothing of the motion.
void MotionTrack::choose_smoothing() {
  constexpr double kThirdDifference = 20.0, kMostResidual = 1.3;
  std::vector<double> noise2[2], residual2[2];
  double weights2 = 0.0;
  std::size_t windows = 0;
  const std::size_t step = std::max<std::size_t>(1, samples_.size() / 2000);
  for (std::size_t i = 2; i + 1 < samples_.size(); i += step) {
    const Window around = window(samples_[i].stamp_ns);
    if (around.first + 2 > i || around.first + around.count < i + 2 || around.count < kFewestInWindow) continue;
    const Eigen::Matrix3Xd weights = parabola_weights(around.times_s);
    const Eigen::Matrix3d back = samples_[i].pose.linear().transpose();
    Eigen::Matrix3Xd position(3, static_cast<Eigen::Index>(around.count)), turn = position;
    for (std::size_t k = 0; k < around.count; ++k) {
      const RigidTransform& pose = samples_[around.first + k].pose;
      position.col(static_cast<Eigen::Index>(k)) = pose.translation() - samples_[i].pose.translation();
      turn.col(static_cast<Eigen::Index>(k)) = so3_log(back * pose.linear());
    }
    const auto at = static_cast<Eigen::Index>(i - around.first);
    const double left = 1.0 - weights(0, at);  // share of its variance that a sample's residual keeps
    const Eigen::Matrix3Xd* values[2] = {&position, &turn};
    for (int kind = 0; kind < 2; ++kind) {
      const Eigen::Matrix3Xd& v = *values[kind];
      const Eigen::Vector3d third = v.col(at + 1) - 3.0 * v.col(at) + 3.0 * v.col(at - 1) - v.col(at - 2);
      noise2[kind].push_back(third.squaredNorm() / kThirdDifference);
      residual2[kind].push_back((v * weights.row(0).transpose()).squaredNorm() / left);
    }
    weights2 += weights.row(0).squaredNorm();
    ++windows;
  }
  constexpr std::size_t kFewest = 30;
  if (windows < kFewest) return;
  const double factor = std::sqrt(weights2 / static_cast<double>(windows));
  Smoothing* kinds[2] = {&position_, &attitude_};
  for (int kind = 0; kind < 2; ++kind) {
    if (median(residual2[kind]) > kMostResidual * kMostResidual * median(noise2[kind])) continue;
    kinds[kind]->on = true;
    kinds[kind]->noise_factor = factor;
  }
}

std::optional<Passage> MotionTrack::around(std::int64_t stamp_ns) const {
  const std::optional<RigidTransform> middle = at(stamp_ns);
  if (!middle) return std::nullopt;
  Passage passage;
  passage.track_ = this;
  passage.stamp_ns_ = stamp_ns;
  if (!position_.on && !attitude_.on) return passage;
  const Window samples = window(stamp_ns);
  if (samples.count < kFewestInWindow / 2) return passage;
  const Eigen::Matrix3Xd weights = parabola_weights(samples.times_s);
  passage.turned_from_ = middle->linear();
  Eigen::Matrix3d position = Eigen::Matrix3d::Zero(), turn = Eigen::Matrix3d::Zero();
  for (std::size_t k = 0; k < samples.count; ++k) {
    const RigidTransform& pose = samples_[samples.first + k].pose;
    const auto weight = weights.col(static_cast<Eigen::Index>(k)).transpose();
    position += pose.translation() * weight;
    turn += so3_log(passage.turned_from_.transpose() * pose.linear()) * weight;
  }
  if (position_.on) passage.position_ = position;
  if (attitude_.on) passage.turn_ = turn;
  return passage;
}

std::optional<RigidTransform> Passage::at(double time_s) const {
  const Eigen::Vector3d powers(1.0, time_s, time_s * time_s);
  RigidTransform pose = RigidTransform::Identity();
  if (!position_ || !turn_) {
    const auto interpolated = track_->at(stamp_ns_ + std::llround(time_s * 1e9));
    if (!interpolated) return std::nullopt;
    pose = *interpolated;
  }
  if (position_) pose.translation() = *position_ * powers;
  if (turn_) pose.linear() = turned_from_ * so3_exp(*turn_ * powers);
  return pose;
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
