#include "algorithms/cloud/deskew.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "algorithms/core/error.h"
#include "messages/motion.h"

namespace remount::cloud {

namespace {

constexpr double kKnotSpacing_s = 0.002;
constexpr double kLongestSweep_s = 10.0;
constexpr float kFarthestMove_m = 1000.0f;  // no sensor moves so far while it measures a scan

using Affine = Eigen::Matrix<float, 3, 4>;

/// The motion at evenly spaced times. Between neighbours the matrices are blended entry by entry: over 2 ms the result
/// is a rotation to within the square of the angle turned, divided by eight.
struct Knots {
  double first_s = 0.0;
  double per_second = 0.0;
  std::vector<Affine> motion;

  Eigen::Vector3f apply(const Eigen::Vector3f& p, float time_s) const {
    const double at =
        std::clamp((static_cast<double>(time_s) - first_s) * per_second, 0.0, static_cast<double>(motion.size() - 1));
    const std::size_t before = std::min(static_cast<std::size_t>(at), motion.size() - 2);
    const float weight = static_cast<float>(at - static_cast<double>(before));
    const Affine& a = motion[before];
    const Affine& b = motion[before + 1];
    const Eigen::Vector3f from_a = a.leftCols<3>() * p + a.col(3), from_b = b.leftCols<3>() * p + b.col(3);
    return from_a + weight * (from_b - from_a);
  }
};

Knots sample_motion(std::span<const float> times_s, const LidarMotion& motion) {
  const auto [first, last] = std::minmax_element(times_s.begin(), times_s.end());
  const double first_s = *first, span_s = std::max(static_cast<double>(*last) - first_s, 1e-6);
  const auto intervals = static_cast<std::size_t>(std::ceil(span_s / kKnotSpacing_s));
  Knots knots{first_s, static_cast<double>(intervals) / span_s, {}};
  for (std::size_t i = 0; i <= intervals; ++i) {
    const RigidTransform at = motion(first_s + span_s * static_cast<double>(i) / static_cast<double>(intervals));
    knots.motion.emplace_back(at.matrix().topRows<3>().cast<float>());
  }
  return knots;
}

bool is_possible(const Knots& knots) {
  return std::all_of(knots.motion.begin(), knots.motion.end(),
                     [](const Affine& motion) { return motion.col(3).norm() < kFarthestMove_m; });
}

void check(const PointCloud& cloud, std::span<const float> times_s) {
  const auto complain = [](Message what) { throw Error(ErrorCode::Contract, "motion compensation", std::move(what)); };
  if (times_s.size() != cloud.size()) complain(say::point_times_of_others(times_s.size(), cloud.size()));
  float low = 0.0f, high = 0.0f;
  for (const float time_s : times_s) {
    if (!std::isfinite(time_s)) complain(say::point_time_not_finite());
    low = std::min(low, time_s);
    high = std::max(high, time_s);
  }
  if (high - low > kLongestSweep_s) complain(say::point_times_far_apart({static_cast<double>(high - low)}));
}

}  // namespace

PointCloud deskew(const PointCloud& cloud_in_lidar, std::span<const float> time_from_stamp_s,
                  const LidarMotion& lidar_at_stamp_from_lidar_at) {
  check(cloud_in_lidar, time_from_stamp_s);
  PointCloud result;
  result.dropped_points = cloud_in_lidar.dropped_points;
  if (cloud_in_lidar.points.empty()) return result;
  const Knots knots = sample_motion(time_from_stamp_s, lidar_at_stamp_from_lidar_at);
  if (!is_possible(knots)) {
    result.dropped_points += cloud_in_lidar.size();
    return result;
  }
  result.intensity = cloud_in_lidar.intensity;
  result.ring = cloud_in_lidar.ring;
  result.points.resize(cloud_in_lidar.size());
  for (std::size_t i = 0; i < cloud_in_lidar.size(); ++i)
    result.points[i] = knots.apply(cloud_in_lidar.points[i], time_from_stamp_s[i]);
  return result;
}

std::vector<float> sweep_times(const PointCloud& cloud_in_lidar, double period_s, double stamp_azimuth_rad,
                               bool clockwise) {
  std::vector<float> times_s(cloud_in_lidar.size());
  const float per_radian = static_cast<float>(period_s / (2.0 * kPi));
  const float whole = static_cast<float>(2.0 * kPi), half = static_cast<float>(kPi);
  const float stamp = static_cast<float>(wrap_angle_rad(stamp_azimuth_rad));
  for (std::size_t i = 0; i < times_s.size(); ++i) {
    const Eigen::Vector3f& p = cloud_in_lidar.points[i];
    float turned = std::atan2(p.y(), p.x()) - stamp;
    if (clockwise) turned = -turned;
    if (turned > half) turned -= whole;
    if (turned <= -half) turned += whole;
    times_s[i] = turned * per_radian;
  }
  return times_s;
}

}  // namespace remount::cloud
