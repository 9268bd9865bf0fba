// What a planner keeps clear: how far the points of a scan are from the vehicle, ahead, behind and beside it.
#pragma once

#include <array>
#include <limits>
#include <vector>

#include "algorithms/geometry/rigid_transform.h"

namespace remount::quality {

/// The vehicle from above and the heights that count, m, in axes x forward, y left, z up with the INS as origin.
struct VehicleBox {
  double front_m = 3.5;  ///< from the INS to the front end
  double rear_m = 1.5;   ///< from the INS to the rear end
  double half_width_m = 1.0;
  double height_min_m = -0.5;  ///< lower is the ground
  double height_max_m = 2.0;   ///< higher are bridges and branches

  bool operator==(const VehicleBox&) const = default;
};

enum class Side { Front, Rear, Left, Right };

/// The nearest point on one side.
struct Clearance {
  double distance_m = std::numeric_limits<double>::infinity();  ///< from the outline; infinite where there is none
  Eigen::Vector3f point_in_vehicle = Eigen::Vector3f::Zero();
};

struct Clearances {
  /// Straight ahead, behind, left and right of the outline, as wide and as long as it is. Order of Side.
  std::array<Clearance, 4> sides;
  Clearance nearest;           ///< in any direction, the corners included
  std::size_t obstacles = 0;   ///< points within the heights and outside the outline
  std::size_t on_vehicle = 0;  ///< within the heights and inside the outline: the vehicle itself
};

inline bool within_heights(const Eigen::Vector3f& point_in_vehicle, const VehicleBox& box) {
  return point_in_vehicle.z() >= box.height_min_m && point_in_vehicle.z() <= box.height_max_m;
}

/// Points that are not finite are ignored.
Clearances find_clearances(const std::vector<Eigen::Vector3f>& points_in_vehicle, const VehicleBox& box);

}  // namespace remount::quality
