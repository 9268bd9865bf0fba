#include "algorithms/odometry/fusion/ackermann.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "algorithms/core/stamps.h"

namespace remount::odometry {
namespace {

constexpr double kLongestGap_s = 0.25;
constexpr double kHeld_s = 0.06;              // beyond the ends of the data
constexpr double kStep_s = 0.005;             // of the integration, at most
constexpr double kStandingSample_mps = 0.05;  // noise of one sample at rest
constexpr double kStanding_mps = 0.02;        // of the mean

/// Value of a stream at a time, linear between neighbours; `value(sample)` is what is asked for.
template <class Sample, class Value>
auto interpolate(const std::vector<Sample>& samples, std::int64_t stamp_ns, Value&& value)
    -> std::optional<std::decay_t<decltype(value(samples.front()))>> {
  if (samples.empty()) return std::nullopt;
  const auto after = std::lower_bound(samples.begin(), samples.end(), stamp_ns,
                                      [](const Sample& sample, std::int64_t at) { return sample.stamp_ns < at; });
  if (after == samples.end()) {
    if (seconds(stamp_ns - samples.back().stamp_ns) > kHeld_s) return std::nullopt;
    return value(samples.back());
  }
  if (after == samples.begin() || after->stamp_ns == stamp_ns) {
    if (seconds(after->stamp_ns - stamp_ns) > kHeld_s) return std::nullopt;
    return value(*after);
  }
  const Sample& before = *(after - 1);
  const double gap_s = seconds(after->stamp_ns - before.stamp_ns);
  if (gap_s > kLongestGap_s) return std::nullopt;
  const double weight = seconds(stamp_ns - before.stamp_ns) / gap_s;
  using Result = std::decay_t<decltype(value(before))>;
  return Result(value(before) * (1.0 - weight) + value(*after) * weight);
}

}  // namespace

RigidTransform DeadReckonedPath::at(double time) const {
  if (time <= time_s.front()) return start_from_vehicle.front();
  if (time >= time_s.back()) return start_from_vehicle.back();
  const auto after = static_cast<std::size_t>(std::upper_bound(time_s.begin(), time_s.end(), time) - time_s.begin());
  const RigidTransform& a = start_from_vehicle[after - 1];
  const RigidTransform& b = start_from_vehicle[after];
  const double weight = (time - time_s[after - 1]) / (time_s[after] - time_s[after - 1]);
  const Eigen::Vector3d turn = so3_log(a.linear().transpose() * b.linear());
  return make_rigid(a.linear() * so3_exp(weight * turn),
                    a.translation() + weight * (b.translation() - a.translation()));
}

DeadReckoning::DeadReckoning(std::vector<motion::ImuSample> imu, std::vector<motion::WheelSample> wheels,
                             const RigidTransform& vehicle_from_imu, double track_width_m)
    : imu_(std::move(imu)), wheels_(std::move(wheels)), track_width_m_(track_width_m) {
  for (motion::ImuSample& sample : imu_)
    sample.angular_rate_radps = vehicle_from_imu.linear() * sample.angular_rate_radps;
  std::erase_if(imu_, [](const motion::ImuSample& sample) { return !sample.angular_rate_radps.allFinite(); });
  std::erase_if(wheels_, [](const motion::WheelSample& sample) {
    return !std::isfinite(sample.rear_left_mps) || !std::isfinite(sample.rear_right_mps);
  });
}

std::optional<double> DeadReckoning::speed_mps(std::int64_t stamp_ns) const {
  return interpolate(wheels_, stamp_ns, [](const motion::WheelSample& sample) {
    return 0.5 * (sample.rear_left_mps + sample.rear_right_mps);
  });
}

std::optional<DeadReckoning::Turning> DeadReckoning::turning(std::int64_t stamp_ns,
                                                             const DeadReckoningState& state) const {
  const auto rate =
      interpolate(imu_, stamp_ns, [](const motion::ImuSample& sample) { return sample.angular_rate_radps; });
  if (rate) return Turning{*rate - state.gyro_bias_radps, true};
  const auto yaw = interpolate(wheels_, stamp_ns, [this](const motion::WheelSample& sample) {
    return (sample.rear_right_mps - sample.rear_left_mps) / track_width_m_;
  });
  if (!yaw) return std::nullopt;
  return Turning{Eigen::Vector3d(0.0, 0.0, *yaw), false};
}

std::optional<DeadReckonedPath> DeadReckoning::path(std::int64_t from_ns, std::int64_t to_ns, std::int64_t origin_ns,
                                                    const DeadReckoningState& state) const {
  if (to_ns < from_ns) return std::nullopt;
  const auto steps = static_cast<std::int64_t>(std::ceil(seconds(to_ns - from_ns) / kStep_s)) + 1;
  if (steps > 100000) return std::nullopt;
  DeadReckonedPath path{{}, {}, std::numeric_limits<double>::quiet_NaN(), true, true, true};
  RigidTransform now = RigidTransform::Identity();
  double distance_m = 0.0;
  for (std::int64_t i = 0; i <= steps; ++i) {
    const std::int64_t stamp_ns = from_ns + (to_ns - from_ns) * i / steps;
    path.time_s.push_back(seconds(stamp_ns - origin_ns));
    path.start_from_vehicle.push_back(now);
    if (i == steps) break;
    const std::int64_t next_ns = from_ns + (to_ns - from_ns) * (i + 1) / steps, middle_ns = (stamp_ns + next_ns) / 2;
    const double dt = seconds(next_ns - stamp_ns);
    const auto rate = turning(middle_ns, state);
    const auto speed = speed_mps(middle_ns);
    path.has_rotation = path.has_rotation && rate.has_value();
    path.by_gyro = path.by_gyro && rate && rate->by_gyro;
    path.has_speed = path.has_speed && speed.has_value();
    if (!path.has_rotation && !path.has_speed) return std::nullopt;
    const Eigen::Vector3d turn = rate ? Eigen::Vector3d(rate->rate_radps * dt) : Eigen::Vector3d::Zero();
    const double step_m = speed ? *speed * state.wheel_scale * dt : 0.0;
    distance_m += step_m;
    now.translation() += now.linear() * so3_left_jacobian(turn).col(0) * step_m;
    now.linear() = now.linear() * so3_exp(turn);
  }
  const double span_s = seconds(to_ns - from_ns);
  if (path.has_speed && span_s > 0.0) path.mean_speed_mps = distance_m / span_s;
  return path;
}

std::optional<Eigen::Vector3d> DeadReckoning::standstill_rate_radps(std::int64_t from_ns, std::int64_t to_ns) const {
  constexpr int kLeastSamples = 3;
  const auto begin_at = [from_ns](const auto& samples) {
    return std::lower_bound(samples.begin(), samples.end(), from_ns,
                            [](const auto& sample, std::int64_t at) { return sample.stamp_ns < at; });
  };
  double speed_sum = 0.0;
  int wheel_count = 0, imu_count = 0;
  for (auto wheel = begin_at(wheels_); wheel != wheels_.end() && wheel->stamp_ns <= to_ns; ++wheel, ++wheel_count) {
    if (std::max(std::abs(wheel->rear_left_mps), std::abs(wheel->rear_right_mps)) > kStandingSample_mps) return {};
    speed_sum += 0.5 * (wheel->rear_left_mps + wheel->rear_right_mps);
  }
  if (wheel_count < kLeastSamples || std::abs(speed_sum) > kStanding_mps * wheel_count) return std::nullopt;
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (auto sample = begin_at(imu_); sample != imu_.end() && sample->stamp_ns <= to_ns; ++sample, ++imu_count)
    sum += sample->angular_rate_radps;
  if (imu_count < kLeastSamples) return std::nullopt;
  return Eigen::Vector3d(sum / imu_count);
}

}  // namespace remount::odometry
