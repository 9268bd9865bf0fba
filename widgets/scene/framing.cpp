#include "widgets/scene/framing.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "algorithms/core/index.h"

namespace remount::scene {
namespace {

constexpr std::size_t kSamples = 20000;
constexpr double kLow = 0.05, kHigh = 0.95;

double percentile(std::vector<double>& values, double share) {
  const auto index = static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), values.begin() + index, values.end());
  return values[index_at(index)];
}

}  // namespace

Framing robust_framing(const std::vector<Eigen::Vector3f>& points_in_lidar, const RigidTransform& view_from_lidar) {
  std::array<std::vector<double>, 3> axes;
  const std::size_t step = std::max<std::size_t>(1, points_in_lidar.size() / kSamples);
  for (std::size_t i = 0; i < points_in_lidar.size(); i += step) {
    if (!points_in_lidar[i].allFinite()) continue;
    const Eigen::Vector3d point_in_view = view_from_lidar * points_in_lidar[i].cast<double>();
    for (int axis = 0; axis < 3; ++axis) axes[index_at(axis)].push_back(point_in_view[axis]);
  }
  Framing framing;
  if (axes[0].empty()) return framing;
  Eigen::Vector3d low, high;
  for (int axis = 0; axis < 3; ++axis) {
    low[axis] = percentile(axes[index_at(axis)], kLow);
    high[axis] = percentile(axes[index_at(axis)], kHigh);
  }
  framing.centre_m = 0.5 * (low + high);
  framing.radius_m = std::max(1.0, 0.5 * (high - low).norm());
  return framing;
}

}  // namespace remount::scene
