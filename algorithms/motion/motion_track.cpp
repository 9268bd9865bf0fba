#include "algorithms/motion/motion_track.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <utility>

#include "algorithms/core/median.h"
#include "algorithms/core/stamps.h"
#include "algorithms/motion/cubic_between.h"

namespace remount::motion {
namespace {

double seconds_between(const StampedPose& from, const StampedPose& to) { return seconds(to.stamp_ns - from.stamp_ns); }

double default_gap_s(const std::vector<StampedPose>& samples) {
  std::vector<double> steps_s;
  for (std::size_t i = 1; i < samples.size(); ++i) steps_s.push_back(seconds_between(samples[i - 1], samples[i]));
  if (steps_s.empty()) return 0.25;
  return std::max(0.25, 5.0 * median_of(std::move(steps_s)));
}

// Half of a window is as long as a sweep: twice the time from its middle to its ends, where a parabola is bent least.
constexpr double kShortWindow_s = 0.1, kLongWindow_s = 0.25;
constexpr std::size_t kFewestInWindow = 11;

// Weights of the least-squares parabola through values at some times: row 0 gives the value at time zero, row 1 the
// slope, row 2 half the curvature.
Eigen::Matrix3Xd parabola_weights(const std::vector<double>& times_s, double half_window_s) {
  Eigen::Matrix3Xd powers(3, static_cast<Eigen::Index>(times_s.size()));
  for (std::size_t i = 0; i < times_s.size(); ++i)
    powers.col(static_cast<Eigen::Index>(i)) << 1.0, times_s[i] / half_window_s,
        times_s[i] * times_s[i] / (half_window_s * half_window_s);
  const Eigen::Matrix3d normal = powers * powers.transpose();
  Eigen::Matrix3Xd weights = normal.ldlt().solve(powers);
  weights.row(1) /= half_window_s;
  weights.row(2) /= half_window_s * half_window_s;
  return weights;
}

// Weights of four values at uneven times that cancel every parabola.
Eigen::Vector4d third_difference_weights(const double* times_s) {
  Eigen::Vector4d weights = Eigen::Vector4d::Ones();
  for (int k = 0; k < 4; ++k)
    for (int j = 0; j < 4; ++j)
      if (j != k) weights[k] *= 0.01 / (times_s[k] - times_s[j]);  // 0.01 s keeps the numbers near one
  return weights;
}

std::vector<StampedPose> samples_at(const std::vector<StampedPose>& samples,
                                    const std::vector<std::int64_t>& stamps_ns) {
  std::vector<StampedPose> out;
  for (const StampedPose& sample : samples)
    if (std::binary_search(stamps_ns.begin(), stamps_ns.end(), sample.stamp_ns)) out.push_back(sample);
  return out;
}

}  // namespace

struct MotionTrack::Window {
  std::size_t first = 0, count = 0;
  std::vector<double> times_s;  // from the stamp
};

MotionTrack::MotionTrack(const std::vector<StampedPose>& world_from_body, double max_gap_s,
                         const std::vector<std::int64_t>& fix_stamps_ns, double sweep_s) {
  samples_.reserve(world_from_body.size());
  for (const StampedPose& sample : world_from_body)
    if (samples_.empty() || sample.stamp_ns > samples_.back().stamp_ns) samples_.push_back(sample);
  max_gap_s_ = max_gap_s > 0.0 ? max_gap_s : default_gap_s(samples_);
  half_window_s_ = std::clamp(sweep_s, kShortWindow_s, kLongWindow_s);
  choose_smoothing();
  if (half_window_s_ > kShortWindow_s && !(position_.on && attitude_.on)) {
    const Smoothing position = position_, attitude = attitude_;
    const double long_window_s = std::exchange(half_window_s_, kShortWindow_s);
    choose_smoothing();
    // What the short window smooths and the long one does not is no parabola for so long.
    if (position_.on == position.on && attitude_.on == attitude.on)
      position_ = position, attitude_ = attitude, half_window_s_ = long_window_s;
  }
  if (!fix_stamps_ns.empty()) position_ = {};  // what was interpolated has no noise
  attitude_spacing_ = spacing_of_attitudes(samples_);
  position_spacing_ = spacing_of_positions(fix_stamps_ns.empty() ? samples_ : samples_at(samples_, fix_stamps_ns));
}

std::optional<BetweenSamples> MotionTrack::between_samples(std::int64_t stamp_ns) const {
  const std::optional<RigidTransform> pose = at(stamp_ns);
  if (!pose) return std::nullopt;
  BetweenSamples out;
  out.after = position_spacing_.knot_before(stamp_ns);
  const Eigen::Matrix3d to_body = pose->linear().transpose();
  out.covariance.topLeftCorner<3, 3>() = to_body * position_spacing_.covariance(stamp_ns) * to_body.transpose();
  out.covariance.bottomRightCorner<3, 3>() = attitude_spacing_.covariance(stamp_ns);
  return out;
}

// Samples within the window that no gap separates from the stamp.
MotionTrack::Window MotionTrack::window(std::int64_t stamp_ns) const {
  const auto from = [&](std::size_t i) { return seconds(samples_[i].stamp_ns - stamp_ns); };
  const auto here = static_cast<std::size_t>(
      std::lower_bound(samples_.begin(), samples_.end(), stamp_ns,
                       [](const StampedPose& sample, std::int64_t stamp) { return sample.stamp_ns < stamp; }) -
      samples_.begin());
  const auto joined = [&](std::size_t left) {
    return seconds_between(samples_[left], samples_[left + 1]) <= max_gap_s_;
  };
  const double edge_s = half_window_s_ + 1e-6;
  Window out;
  std::size_t first = here, last = here;  // [first, last)
  while (last < samples_.size() && from(last) <= edge_s && (last == here || joined(last - 1))) ++last;
  while (first > 0 && from(first - 1) >= -edge_s && (first == samples_.size() || joined(first - 1))) --first;
  out.first = first;
  out.count = last - first;
  for (std::size_t i = first; i < last; ++i) out.times_s.push_back(from(i));
  return out;
}

// What white noise and smooth motion look like in one window: squares of position (0) and of attitude (1).
struct MotionTrack::Roughness {
  double noise2[2] = {0.0, 0.0};     // from third differences, which smooth motion hardly enters
  double residual2[2] = {0.0, 0.0};  // of the parabola
  double weights2 = 0.0;             // sum of its squared weights
};

std::optional<MotionTrack::Roughness> MotionTrack::roughness(std::size_t sample) const {
  const Window around = window(samples_[sample].stamp_ns);
  if (around.first + 2 > sample || around.first + around.count < sample + 2 || around.count < kFewestInWindow)
    return std::nullopt;
  const Eigen::Matrix3Xd weights = parabola_weights(around.times_s, half_window_s_);
  const Eigen::Matrix3d back = samples_[sample].pose.linear().transpose();
  Eigen::Matrix3Xd values[2];
  for (Eigen::Matrix3Xd& v : values) v.resize(3, static_cast<Eigen::Index>(around.count));
  for (std::size_t k = 0; k < around.count; ++k) {
    const RigidTransform& pose = samples_[around.first + k].pose;
    values[0].col(static_cast<Eigen::Index>(k)) = pose.translation() - samples_[sample].pose.translation();
    values[1].col(static_cast<Eigen::Index>(k)) = so3_log(back * pose.linear());
  }
  // A vehicle at rest says nothing about what smoothing does to motion.
  constexpr double kMoves_mps = 0.3, kTurns_radps = 0.03;
  if ((values[0] * weights.row(1).transpose()).norm() < kMoves_mps &&
      (values[1] * weights.row(1).transpose()).norm() < kTurns_radps)
    return std::nullopt;
  const std::size_t at = sample - around.first;
  const Eigen::Vector4d third = third_difference_weights(&around.times_s[at - 2]);
  const double left = 1.0 - weights(0, static_cast<Eigen::Index>(at));  // share of its variance that a residual keeps
  Roughness out;
  for (int kind = 0; kind < 2; ++kind) {
    out.noise2[kind] =
        (values[kind].middleCols<4>(static_cast<Eigen::Index>(at) - 2) * third).squaredNorm() / third.squaredNorm();
    out.residual2[kind] = (values[kind] * weights.row(0).transpose()).squaredNorm() / left;
  }
  out.weights2 = weights.row(0).squaredNorm();
  return out;
}

// Smooths where a parabola leaves just what is noise: it loses nothing of the motion then. Much less than the alleged
// noise is no noise either, but stamps or motion that third differences do not fit.
void MotionTrack::choose_smoothing() {
  constexpr double kMostRatio2 = 1.3 * 1.3;
  constexpr std::size_t kFewest = 30, kMost = 2000;
  constexpr double kRounding2[2] = {1e-12, 1e-16};  // a micrometre and 1e-8 rad are digits, not noise
  std::vector<double> noise2[2], residual2[2];
  double weights2 = 0.0;
  const std::size_t step = std::max<std::size_t>(1, samples_.size() / kMost);
  for (std::size_t i = 2; i + 1 < samples_.size(); i += step) {
    const std::optional<Roughness> here = roughness(i);
    if (!here) continue;
    for (int kind = 0; kind < 2; ++kind) {
      noise2[kind].push_back(here->noise2[kind]);
      residual2[kind].push_back(here->residual2[kind]);
    }
    weights2 += here->weights2;
  }
  position_ = attitude_ = {};
  if (noise2[0].size() < kFewest) return;
  Smoothing* kinds[2] = {&position_, &attitude_};
  for (int kind = 0; kind < 2; ++kind) {
    const double noise = median_of(noise2[kind]), residual = median_of(residual2[kind]);
    if (!(noise > kRounding2[kind]) || residual > kMostRatio2 * noise || residual * kMostRatio2 < noise) continue;
    kinds[kind]->on = true;
    kinds[kind]->noise_factor = std::sqrt(weights2 / static_cast<double>(noise2[kind].size()));
  }
}

std::optional<Passage> MotionTrack::around(std::int64_t stamp_ns, double middle_s) const& {
  const std::optional<RigidTransform> here = at(stamp_ns);
  if (!here) return std::nullopt;
  Passage passage;
  passage.track_ = this;
  passage.stamp_ns_ = stamp_ns;
  if (!position_.on && !attitude_.on) return passage;
  middle_s = std::clamp(middle_s, -half_window_s_, half_window_s_);  // the stamp's own pose is of the fit
  const std::int64_t middle_ns = stamp_ns + std::llround(1e9 * middle_s);
  const std::optional<RigidTransform> middle = at(middle_ns);
  const Window samples = window(middle ? middle_ns : stamp_ns);
  if (samples.count < kFewestInWindow / 2) return passage;
  const Eigen::Matrix3Xd weights = parabola_weights(samples.times_s, half_window_s_);
  passage.middle_s_ = middle ? middle_s : 0.0;
  passage.half_window_s_ = half_window_s_;
  passage.turned_from_ = middle ? middle->linear() : here->linear();
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

RigidTransform Passage::fitted(double time_s, const RigidTransform& interpolated) const {
  const double from_middle_s = time_s - middle_s_;
  const Eigen::Vector3d powers(1.0, from_middle_s, from_middle_s * from_middle_s);
  RigidTransform pose = interpolated;
  if (position_) pose.translation() = *position_ * powers;
  if (turn_) pose.linear() = turned_from_ * so3_exp(*turn_ * powers);
  return pose;
}

std::optional<RigidTransform> Passage::at(double time_s) const {
  const auto interpolated = [&](double t_s) { return track_->at(stamp_ns_ + std::llround(t_s * 1e9)); };
  const double inside_s = std::clamp(time_s, middle_s_ - half_window_s_, middle_s_ + half_window_s_);
  std::optional<RigidTransform> base = interpolated(inside_s);
  // The fit goes on where the data end or pause within its window.
  if (!base && position_ && turn_) base = RigidTransform::Identity();
  if (!base) return std::nullopt;
  const RigidTransform at_edge = fitted(inside_s, *base);
  if (inside_s == time_s || (!position_ && !turn_)) return inside_s == time_s ? at_edge : interpolated(time_s);
  // Beyond the window a parabola would run away: the interpolated motion joins at its edge.
  const auto edge = interpolated(inside_s), beyond = interpolated(time_s);
  if (!edge || !beyond) return std::nullopt;
  return RigidTransform(at_edge * edge->inverse() * *beyond);
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
  CubicNeighbours places;
  places.has_first = before != samples_.begin() && seconds_between(*(before - 1), *before) <= max_gap_s_;
  places.has_last = after + 1 != samples_.end() && seconds_between(*after, *(after + 1)) <= max_gap_s_;
  CubicNeighbours turns = places;
  const Eigen::Matrix3d before_from_world = before->pose.linear().transpose();
  // Of samples that are close the turn between the two is straight, and the neighbours would only add their noise.
  if (attitude_spacing_.empty()) turns.has_first = turns.has_last = false;
  for (std::size_t i = 0; i < 4; ++i) {
    if ((i == 0 && !places.has_first) || (i == 3 && !places.has_last)) continue;
    const StampedPose& sample = *(before + static_cast<std::ptrdiff_t>(i) - 1);
    places.times_s[i] = turns.times_s[i] = seconds(sample.stamp_ns - before->stamp_ns);
    places.values[i] = sample.pose.translation();
    if ((i == 0 && !turns.has_first) || (i == 3 && !turns.has_last)) continue;
    turns.values[i] =
        i == 1 ? Eigen::Vector3d(Eigen::Vector3d::Zero()) : so3_log(before_from_world * sample.pose.linear());
  }
  const double time_s = seconds(stamp_ns - before->stamp_ns);
  return make_rigid(before->pose.linear() * so3_exp(cubic_between(turns, time_s)), cubic_between(places, time_s));
}

// The slope of a weighted least-squares line through the motions from here to places that are evenly apart. Weights
// fall to zero at kReach half windows: turns bend the ends of the line most.
std::optional<Vector6d> MotionTrack::slope(std::int64_t stamp_ns, std::int64_t back_ns, std::int64_t forth_ns) const {
  constexpr int kPlaces = 11;
  constexpr double kReach = 1.2;
  const std::optional<RigidTransform> here = at(stamp_ns);
  if (!here) return std::nullopt;
  const double middle_s = 0.5 * seconds(forth_ns - back_ns), reach_s = kReach * 0.5 * seconds(forth_ns + back_ns);
  Vector6d by_time = Vector6d::Zero(), sum = Vector6d::Zero();
  double weights = 0.0, times_s = 0.0, squares_s2 = 0.0;
  for (int place = 0; place < kPlaces; ++place) {
    const std::int64_t shift_ns = -back_ns + (back_ns + forth_ns) * place / (kPlaces - 1);
    const std::optional<RigidTransform> there = shift_ns == 0 ? here : at(stamp_ns + shift_ns);
    if (!there) return std::nullopt;
    // As a screw: at an even speed and rate it grows evenly with time.
    const Eigen::Vector3d turn = so3_log(here->linear().transpose() * there->linear());
    const Eigen::Vector3d way = here->linear().transpose() * (there->translation() - here->translation());
    Vector6d move;
    move << so3_left_jacobian_inverse(turn) * way, turn;
    const double time_s = seconds(shift_ns), weight = 1.0 - std::pow((time_s - middle_s) / reach_s, 2);
    weights += weight;
    by_time += weight * time_s * move;
    sum += weight * move;
    times_s += weight * time_s;
    squares_s2 += weight * time_s * time_s;
  }
  return (by_time - times_s / weights * sum) / (squares_s2 - times_s * times_s / weights);
}

std::optional<Vector6d> MotionTrack::body_velocity(std::int64_t stamp_ns) const {
  // What a vehicle's speed varies by within a second is less than what the errors of samples make of it in less time: a
  // lag of the positions would seem to be seen where the speed is even. It turns faster than that.
  constexpr std::int64_t kOfWay_ns = 500'000'000, kOfTurn_ns = 200'000'000, kShort_ns = 40'000'000;
  // As much to either side as there is.
  const auto slope_within = [&](std::int64_t half_ns) -> std::optional<Vector6d> {
    for (const std::int64_t least_ns : {half_ns, half_ns / 2, std::int64_t{0}})
      for (const auto& [back_ns, forth_ns] : {std::pair{least_ns, half_ns}, std::pair{half_ns, least_ns}})
        if (const auto velocity = slope(stamp_ns, back_ns, forth_ns)) return velocity;
    return std::nullopt;
  };
  std::optional<Vector6d> velocity = slope_within(kOfTurn_ns);
  if (!velocity) velocity = slope_within(kShort_ns);
  const std::optional<Vector6d> of_way = slope_within(kOfWay_ns);
  if (velocity && of_way) velocity->head<3>() = of_way->head<3>();
  return velocity;
}

}  // namespace remount::motion
