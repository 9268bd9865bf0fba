#include "algorithms/cloud/sweep_order.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "algorithms/geometry/rotation.h"

namespace remount::cloud {

std::optional<SweepOrder> sweep_order(const PointCloud& cloud) {
  constexpr std::size_t kParts = 48;
  constexpr double kNearest_m = 1.0;  // nearer points are of the vehicle, at any azimuth
  if (cloud.size() < 16 * kParts) return std::nullopt;
  std::vector<double> azimuths_rad;  // the mean of each part
  for (std::size_t part = 0; part < kParts; ++part) {
    Eigen::Vector2d sum = Eigen::Vector2d::Zero();
    double count = 0.0;
    for (std::size_t i = part * cloud.size() / kParts; i < (part + 1) * cloud.size() / kParts; ++i) {
      const Eigen::Vector2d flat = cloud.points[i].head<2>().cast<double>();
      if (flat.norm() < kNearest_m) continue;
      sum += flat.normalized();
      count += 1.0;
    }
    constexpr double kTogether = 0.8;  // points of a part of a turn lie on one side
    if (!(sum.norm() > kTogether * count)) return std::nullopt;
    azimuths_rad.push_back(std::atan2(sum.y(), sum.x()));
  }
  double turned_rad = 0.0;
  int backward = 0, forward = 0;
  for (std::size_t part = 1; part < kParts; ++part) {
    const double step_rad = wrap_angle_rad(azimuths_rad[part] - azimuths_rad[part - 1]);
    turned_rad += step_rad;
    ++(step_rad > 0.0 ? forward : backward);
  }
  const double whole_turns = std::abs(turned_rad) / (2.0 * kPi);
  const bool one_turn = whole_turns > 0.75 && whole_turns < 1.1;
  if (!one_turn || std::min(forward, backward) > static_cast<int>(kParts) / 10) return std::nullopt;
  // The middle of the first part is half of it from where the sweep begins.
  const double half_a_part_rad = 0.5 * turned_rad / static_cast<double>(kParts - 1);
  return SweepOrder{turned_rad < 0.0, wrap_angle_rad(azimuths_rad.front() - half_a_part_rad)};
}

bool looks_around(const PointCloud& cloud) {
  constexpr std::size_t kSectors = 36, kMostEmpty = 10;  // a body may hide a quarter of the view
  std::array<bool, kSectors> seen{};
  for (const Eigen::Vector3f& point : cloud.points) {
    const double turns = std::atan2(point.y(), point.x()) / (2.0 * kPi) + 0.5;
    seen[std::min(kSectors - 1, static_cast<std::size_t>(turns * kSectors))] = true;
  }
  return std::count(seen.begin(), seen.end(), false) <= static_cast<std::ptrdiff_t>(kMostEmpty);
}

}  // namespace remount::cloud
