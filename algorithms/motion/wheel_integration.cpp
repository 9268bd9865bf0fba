#include "algorithms/motion/wheel_integration.h"

#include <algorithm>
#include <cmath>

#include "algorithms/core/index.h"
#include "algorithms/core/median.h"
#include "algorithms/core/stamps.h"

namespace remount::motion {
namespace {

template <class Sample>
std::vector<Sample> ascending(const std::vector<Sample>& samples, bool (*finite)(const Sample&)) {
  std::vector<Sample> kept;
  kept.reserve(samples.size());
  for (const Sample& sample : samples)
    if (finite(sample) && (kept.empty() || sample.stamp_ns > kept.back().stamp_ns)) kept.push_back(sample);
  return kept;
}

template <class Sample>
std::int64_t longest_step_ns(const std::vector<Sample>& samples) {
  constexpr std::int64_t kAtLeast_ns = 250'000'000;
  std::vector<std::int64_t> steps;
  for (std::size_t i = 1; i < samples.size(); ++i) steps.push_back(samples[i].stamp_ns - samples[i - 1].stamp_ns);
  if (steps.empty()) return kAtLeast_ns;
  return std::max(kAtLeast_ns, 5 * median_of(std::move(steps)));
}

// The first sample at or after a time.
template <class Sample>
std::size_t first_from(const std::vector<Sample>& samples, std::int64_t stamp_ns) {
  return static_cast<std::size_t>(
      std::lower_bound(samples.begin(), samples.end(), stamp_ns,
                       [](const Sample& sample, std::int64_t stamp) { return sample.stamp_ns < stamp; }) -
      samples.begin());
}

template <class Sample>
bool is_covered(const std::vector<Sample>& samples, std::int64_t from_ns, std::int64_t to_ns, std::int64_t gap_ns) {
  if (samples.empty() || from_ns < samples.front().stamp_ns || to_ns > samples.back().stamp_ns) return false;
  const std::size_t last = first_from(samples, to_ns);
  for (std::size_t i = std::max<std::size_t>(1, first_from(samples, from_ns)); i <= last; ++i)
    if (samples[i].stamp_ns - samples[i - 1].stamp_ns > gap_ns) return false;
  return true;
}

// Share of the way from the sample before index `i` to it.
template <class Sample>
double share(const std::vector<Sample>& samples, std::size_t i, std::int64_t stamp_ns) {
  return static_cast<double>(stamp_ns - samples[i - 1].stamp_ns) /
         static_cast<double>(samples[i].stamp_ns - samples[i - 1].stamp_ns);
}

Eigen::Vector3d rate_at(const std::vector<ImuSample>& imu, std::size_t i, std::int64_t stamp_ns) {
  i = std::clamp<std::size_t>(i, 1, imu.size() - 1);
  const double t = share(imu, i, stamp_ns);
  return (1.0 - t) * imu[i - 1].angular_rate_radps + t * imu[i].angular_rate_radps;
}

Eigen::Vector2d speeds_at(const std::vector<WheelSample>& wheels, std::size_t& i, std::int64_t stamp_ns) {
  while (i + 1 < wheels.size() && wheels[i].stamp_ns < stamp_ns) ++i;
  const double t = share(wheels, i, stamp_ns);
  const auto speeds = [](const WheelSample& sample) {
    return Eigen::Vector2d(sample.rear_left_mps, sample.rear_right_mps);
  };
  return (1.0 - t) * speeds(wheels[i - 1]) + t * speeds(wheels[i]);
}

bool finite_rate(const ImuSample& sample) { return sample.angular_rate_radps.allFinite(); }
bool finite_speed(const WheelSample& sample) {
  return std::isfinite(sample.rear_left_mps) && std::isfinite(sample.rear_right_mps);
}

}  // namespace

WheelImuSignals::WheelImuSignals(const std::vector<ImuSample>& imu, const std::vector<WheelSample>& wheels)
    : imu_(ascending(imu, finite_rate)), wheels_(ascending(wheels, finite_speed)) {
  imu_gap_ns_ = longest_step_ns(imu_);
  wheel_gap_ns_ = longest_step_ns(wheels_);
  wheels_differ_ = std::any_of(wheels_.begin(), wheels_.end(),
                               [](const WheelSample& sample) { return sample.rear_left_mps != sample.rear_right_mps; });
  one_axis_ = !imu_.empty() && std::all_of(imu_.begin(), imu_.end(), [](const ImuSample& sample) {
    return sample.angular_rate_radps.x() == 0.0 && sample.angular_rate_radps.y() == 0.0;
  });
}

std::int64_t WheelImuSignals::begin_ns() const {
  if (imu_.size() < 2 || wheels_.size() < 2) return 0;
  return std::max(imu_.front().stamp_ns, wheels_.front().stamp_ns);
}

std::int64_t WheelImuSignals::end_ns() const {
  if (imu_.size() < 2 || wheels_.size() < 2) return 0;
  return std::min(imu_.back().stamp_ns, wheels_.back().stamp_ns);
}

std::optional<std::vector<MotionStep>> WheelImuSignals::steps(std::int64_t from_ns, std::int64_t to_ns) const {
  if (to_ns <= from_ns || imu_.size() < 2 || wheels_.size() < 2) return std::nullopt;
  if (!is_covered(imu_, from_ns, to_ns, imu_gap_ns_) || !is_covered(wheels_, from_ns, to_ns, wheel_gap_ns_))
    return std::nullopt;
  std::vector<MotionStep> steps;
  std::size_t wheel = std::max<std::size_t>(1, first_from(wheels_, from_ns));
  std::size_t next = first_from(imu_, from_ns + 1);
  for (std::int64_t begin = from_ns; begin < to_ns; ++next) {
    const std::int64_t end = std::min(to_ns, imu_[next].stamp_ns);
    MotionStep step;
    step.duration_s = seconds(end - begin);
    step.turn_in_imu_rad = 0.5 * (rate_at(imu_, next, begin) + rate_at(imu_, next, end)) * step.duration_s;
    // Simpson's rule: exact while the speeds are linear, and nearly so where a wheel sample lies within the step.
    const Eigen::Vector2d first = speeds_at(wheels_, wheel, begin);
    const Eigen::Vector2d middle = speeds_at(wheels_, wheel, begin + (end - begin) / 2);
    const Eigen::Vector2d ways = (first + 4.0 * middle + speeds_at(wheels_, wheel, end)) / 6.0 * step.duration_s;
    step.travel_m = 0.5 * (ways[0] + ways[1]);
    step.wheel_difference_m = ways[1] - ways[0];
    steps.push_back(step);
    begin = end;
  }
  return steps;
}

RigidTransform advance(const RigidTransform& world_from_vehicle, const Eigen::Vector3d& turn_rad, double travel_m,
                       WheelIntegration integration) {
  const Eigen::Vector3d forward = travel_m * Eigen::Vector3d::UnitX();
  if (integration == WheelIntegration::Planar) {
    const double yaw_rad = yaw_pitch_roll_from_rotation(world_from_vehicle.linear()).yaw_rad;
    const Eigen::Vector3d turn = turn_rad.z() * Eigen::Vector3d::UnitZ();
    const Eigen::Matrix3d plane_from_vehicle = so3_exp(yaw_rad * Eigen::Vector3d::UnitZ());
    return make_rigid(plane_from_vehicle * so3_exp(turn),
                      world_from_vehicle.translation() + plane_from_vehicle * so3_left_jacobian(turn) * forward);
  }
  const bool closed = integration == WheelIntegration::ClosedForm;
  const Eigen::Vector3d way = closed ? Eigen::Vector3d(so3_left_jacobian(turn_rad) * forward) : forward;
  return make_rigid(world_from_vehicle.linear() * so3_exp(turn_rad), world_from_vehicle * way);
}

std::vector<RigidTransform> integrate_steps(const std::vector<MotionStep>& steps,
                                            const RigidTransform& world_from_vehicle_start,
                                            const Eigen::Matrix3d& vehicle_from_imu,
                                            const Eigen::Vector3d& rate_bias_radps, WheelIntegration integration) {
  std::vector<RigidTransform> poses{world_from_vehicle_start};
  poses.reserve(steps.size() + 1);
  for (const MotionStep& step : steps) {
    const Eigen::Vector3d turn_rad = vehicle_from_imu * (step.turn_in_imu_rad - rate_bias_radps * step.duration_s);
    poses.push_back(advance(poses.back(), turn_rad, step.travel_m, integration));
  }
  return poses;
}

RigidTransform WheelPreintegration::start_from_end(const Eigen::Matrix3d& vehicle_from_imu, double wheel_scale,
                                                   double pitch_centre_m, double wheel_asymmetry) const {
  const Eigen::Vector3d x = vehicle_from_imu.row(0), y = vehicle_from_imu.row(1), z = vehicle_from_imu.row(2);
  Eigen::Vector3d moved_m = wheel_scale * (travel_map_m + 0.5 * wheel_asymmetry * difference_map_m) * x;
  for (int axis = 0; axis < 3; ++axis) moved_m += pitch_centre_m * z[axis] * turn_maps_rad[index_at(axis)] * y;
  return make_rigid(vehicle_from_imu * imu_start_from_imu_end * vehicle_from_imu.transpose(),
                    vehicle_from_imu * moved_m);
}

WheelPreintegration preintegrate(const std::vector<MotionStep>& steps, const Eigen::Vector3d& rate_bias_radps,
                                 const Eigen::Vector3d& rate_scale) {
  WheelPreintegration sum;
  for (const MotionStep& step : steps) {
    const Eigen::Vector3d turn_rad = rate_scale.cwiseProduct(step.turn_in_imu_rad) - rate_bias_radps * step.duration_s;
    const Eigen::Matrix3d mean_rotation = sum.imu_start_from_imu_end * so3_left_jacobian(turn_rad);
    sum.travel_map_m += step.travel_m * mean_rotation;
    sum.difference_map_m += step.wheel_difference_m * mean_rotation;
    for (int axis = 0; axis < 3; ++axis)
      sum.turn_maps_rad[index_at(axis)] += mean_rotation.col(axis) * turn_rad.transpose();
    sum.imu_start_from_imu_end = sum.imu_start_from_imu_end * so3_exp(turn_rad);
    sum.turn_in_imu_rad += turn_rad;
    sum.duration_s += step.duration_s;
    sum.travel_m += step.travel_m;
    sum.wheel_difference_m += step.wheel_difference_m;
  }
  sum.imu_start_from_imu_end = nearest_rotation(sum.imu_start_from_imu_end);
  return sum;
}

}  // namespace remount::motion
