#include "algorithms/quality/clearance.h"

#include <cmath>

#include "algorithms/core/index.h"

namespace remount::quality {

Clearances find_clearances(const std::vector<Eigen::Vector3f>& points_in_vehicle, const VehicleBox& box) {
  Clearances found;
  const auto keep_nearer = [](Clearance& clearance, double distance_m, const Eigen::Vector3f& point) {
    if (distance_m < clearance.distance_m) clearance = {distance_m, point};
  };
  const auto side = [&](Side which) -> Clearance& { return found.sides[index_of(which)]; };
  for (const Eigen::Vector3f& point : points_in_vehicle) {
    if (!point.allFinite() || !within_heights(point, box)) continue;
    const double ahead_m = point.x() - box.front_m, behind_m = -box.rear_m - point.x();
    const double left_m = point.y() - box.half_width_m, right_m = -box.half_width_m - point.y();
    const double along_m = std::max(ahead_m, behind_m), across_m = std::max(left_m, right_m);
    if (along_m <= 0.0 && across_m <= 0.0) {
      ++found.on_vehicle;
      continue;
    }
    ++found.obstacles;
    keep_nearer(found.nearest, std::hypot(std::max(along_m, 0.0), std::max(across_m, 0.0)), point);
    if (across_m <= 0.0) keep_nearer(side(ahead_m > 0.0 ? Side::Front : Side::Rear), along_m, point);
    if (along_m <= 0.0) keep_nearer(side(left_m > 0.0 ? Side::Left : Side::Right), across_m, point);
  }
  return found;
}

}  // namespace remount::quality
