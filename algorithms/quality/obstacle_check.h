// What X is for: how far the obstacles of a scan are from the vehicle, and whether to stop.
#pragma once

#include <limits>
#include <vector>

#include "algorithms/cloud/objects.h"
#include "algorithms/core/options.h"
#include "algorithms/geometry/rigid_transform.h"
#include "messages/options.h"

namespace remount::quality {

/// The vehicle's outline seen from above, in the vehicle's axes (x forward, y left, z up, origin at the INS), and when
/// to stop.
struct ObstacleOptions {
  double outline_x_min_m = -1.5;
  double outline_x_max_m = 3.5;
  double outline_y_min_m = -1.0;
  double outline_y_max_m = 1.0;
  double clearance_above_m = 2.5;
  double stop_distance_m = 2.0;
  bool ignore_inside = true;

  template <class Self, class Visitor>
  static void visit(Self& self, Visitor&& visitor) {
    visitor({"outline_x_min_m", "m", say::option_obstacles_outline_x_min_m, say::option_obstacles_outline_x_min_m_help,
             -50.0, 50.0},
            self.outline_x_min_m);
    visitor({"outline_x_max_m", "m", say::option_obstacles_outline_x_max_m, say::option_obstacles_outline_x_max_m_help,
             -50.0, 50.0},
            self.outline_x_max_m);
    visitor({"outline_y_min_m", "m", say::option_obstacles_outline_y_min_m, say::option_obstacles_outline_y_min_m_help,
             -50.0, 50.0},
            self.outline_y_min_m);
    visitor({"outline_y_max_m", "m", say::option_obstacles_outline_y_max_m, say::option_obstacles_outline_y_max_m_help,
             -50.0, 50.0},
            self.outline_y_max_m);
    visitor({"clearance_above_m", "m", say::option_obstacles_clearance_above_m,
             say::option_obstacles_clearance_above_m_help, 0.0, 50.0},
            self.clearance_above_m);
    visitor({"stop_distance_m", "m", say::option_obstacles_stop_distance_m, say::option_obstacles_stop_distance_m_help,
             0.0, 200.0},
            self.stop_distance_m);
    visitor({"ignore_inside", "", say::option_obstacles_ignore_inside, say::option_obstacles_ignore_inside_help},
            self.ignore_inside);
  }
};

enum class ObstacleDecision { Clear, Stop };
/// "clear", "stop".
std::string_view to_string(ObstacleDecision decision);

struct Obstacle {
  int object = 0;  ///< index into the objects given
  cloud::ObjectShape shape = cloud::ObjectShape::Small;
  double distance_m = 0.0;  ///< in the plane, of its nearest point to the outline; 0 where it reaches into it
  Eigen::Vector3d nearest_point_in_vehicle = Eigen::Vector3d::Zero();
  Eigen::Vector3d centroid_in_vehicle = Eigen::Vector3d::Zero();
};

struct ObstacleCheck {
  std::vector<Obstacle> obstacles;  ///< nearest first
  double nearest_m = std::numeric_limits<double>::infinity();
  ObstacleDecision decision = ObstacleDecision::Clear;
};

/// The objects of a scan (find_objects on the same cloud) taken to the vehicle's axes by `vehicle_from_lidar`.
/// Throws Error(Contract) where options are out of range, the outline is empty, or an object refers to points that the
/// cloud does not have.
ObstacleCheck check_obstacles(const cloud::PointCloud& cloud_in_lidar, const std::vector<cloud::SceneObject>& objects,
                              const RigidTransform& vehicle_from_lidar, const ObstacleOptions& options);

/// One obstacle under two mountings. Not a number where it is no obstacle under that mounting (inside the outline, too
/// high).
struct ObstacleDifference {
  int object = 0;
  cloud::ObjectShape shape = cloud::ObjectShape::Small;
  double nominal_distance_m = std::numeric_limits<double>::quiet_NaN();
  double calibrated_distance_m = std::numeric_limits<double>::quiet_NaN();
};

struct ObstacleComparison {
  ObstacleCheck nominal, calibrated;
  std::vector<ObstacleDifference> rows;  ///< by object
  bool decision_differs() const { return nominal.decision != calibrated.decision; }
};

/// The same scan under the nominal and under the new mounting, side by side.
ObstacleComparison compare_obstacles(const cloud::PointCloud& cloud_in_lidar,
                                     const std::vector<cloud::SceneObject>& objects,
                                     const RigidTransform& nominal_vehicle_from_lidar,
                                     const RigidTransform& calibrated_vehicle_from_lidar,
                                     const ObstacleOptions& options);

}  // namespace remount::quality
