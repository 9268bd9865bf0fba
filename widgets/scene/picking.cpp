#include "widgets/scene/picking.h"

#include <algorithm>
#include <cmath>

namespace remount::scene {
namespace {

struct Seen {
  double along_m = 0.0;
  double tangent = 0.0;  // of the angle between ray and point
};

std::optional<Seen> seen_from(const Eigen::Vector3d& origin, const Eigen::Vector3d& direction,
                              const Eigen::Vector3f& point) {
  const Eigen::Vector3d offset = point.cast<double>() - origin;
  const double along_m = offset.dot(direction);
  if (!(along_m > 0.0) || !std::isfinite(along_m)) return std::nullopt;
  return Seen{along_m, (offset - along_m * direction).norm() / along_m};
}

}  // namespace

std::optional<double> least_tangent_to_ray(const std::vector<Eigen::Vector3f>& points, const Eigen::Vector3d& origin,
                                           const Eigen::Vector3d& direction, double most) {
  double least = most;
  bool any = false;
  for (const Eigen::Vector3f& point : points) {
    const auto seen = seen_from(origin, direction, point);
    if (!seen || seen->tangent > least) continue;
    least = seen->tangent;
    any = true;
  }
  return any ? std::optional(least) : std::nullopt;
}

std::optional<PickedPoint> first_within(const std::vector<Eigen::Vector3f>& points, const Eigen::Vector3d& origin,
                                        const Eigen::Vector3d& direction, double most) {
  std::optional<PickedPoint> picked;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const auto seen = seen_from(origin, direction, points[i]);
    if (!seen || seen->tangent > most || (picked && seen->along_m >= picked->distance_m)) continue;
    picked = PickedPoint{i, std::atan(seen->tangent), seen->along_m};
  }
  return picked;
}

std::optional<PickedPoint> nearest_to_ray(const std::vector<Eigen::Vector3f>& points_in_cloud,
                                          const RigidTransform& view_from_cloud, const PickRay& ray, double reach_px) {
  // The ray goes to the cloud's frame: one transform instead of one for each point.
  const RigidTransform cloud_from_view = view_from_cloud.inverse();
  const Eigen::Vector3d origin = cloud_from_view * ray.origin_in_view;
  const Eigen::Vector3d direction = (cloud_from_view.linear() * ray.direction_in_view).normalized();
  const auto least =
      least_tangent_to_ray(points_in_cloud, origin, direction, std::tan(std::min(reach_px * ray.pixel_rad, 1.5)));
  if (!least) return std::nullopt;
  return first_within(points_in_cloud, origin, direction, *least + ray.pixel_rad);
}

}  // namespace remount::scene
