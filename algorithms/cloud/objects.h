// Objects in a scan, and the same objects in two scans. docs/maths/pairwise.md, "Keyframes and pairs"
#pragma once

#include <Eigen/Core>
#include <utility>
#include <vector>

#include "algorithms/cloud/point_cloud.h"
#include "algorithms/core/options.h"
#include "algorithms/geometry/rigid_transform.h"
#include "algorithms/messages/message.h"
#include "messages/options.h"

namespace remount::cloud {

struct ObjectOptions {
  double ground_cell_m = 1.0;
  double ground_height_m = 0.3;
  double cluster_distance_m = 0.5;
  int min_points = 15;
  int max_points = 20000;
  double max_range_m = 50.0;
  double association_distance_m = 2.0;
  double moving_distance_m = 0.6;

  template <class Self, class Visitor>
  static void visit(Self& self, Visitor&& visitor) {
    visitor(
        {"ground_cell_m", "m", say::option_objects_ground_cell_m, say::option_objects_ground_cell_m_help, 0.2, 10.0},
        self.ground_cell_m);
    visitor({"ground_height_m", "m", say::option_objects_ground_height_m, say::option_objects_ground_height_m_help,
             0.05, 2.0},
            self.ground_height_m);
    visitor({"cluster_distance_m", "m", say::option_objects_cluster_distance_m,
             say::option_objects_cluster_distance_m_help, 0.05, 5.0},
            self.cluster_distance_m);
    visitor({"min_points", "", say::option_objects_min_points, say::option_objects_min_points_help, 3, 10000},
            self.min_points);
    visitor({"max_points", "", say::option_objects_max_points, say::option_objects_max_points_help, 100, 10000000},
            self.max_points);
    visitor({"max_range_m", "m", say::option_objects_max_range_m, say::option_objects_max_range_m_help, 5.0, 500.0},
            self.max_range_m);
    visitor({"association_distance_m", "m", say::option_objects_association_distance_m,
             say::option_objects_association_distance_m_help, 0.1, 20.0},
            self.association_distance_m);
    visitor({"moving_distance_m", "m", say::option_objects_moving_distance_m,
             say::option_objects_moving_distance_m_help, 0.05, 10.0},
            self.moving_distance_m);
  }
};

enum class ObjectShape { Pole, Facade, VehicleSized, Small, Large };
/// "pole", "vehicle-sized".
Message shape_word(ObjectShape shape);

/// A cluster of points above the ground.
struct SceneObject {
  ObjectShape shape = ObjectShape::Small;
  Eigen::Vector3f centroid_in_lidar = Eigen::Vector3f::Zero();  ///< m
  Eigen::Vector3f box_min_in_lidar = Eigen::Vector3f::Zero();   ///< m, axis-aligned in the lidar frame
  Eigen::Vector3f box_max_in_lidar = Eigen::Vector3f::Zero();
  /// Square roots of the eigenvalues of the points' covariance, ascending: independent of the sensor's orientation.
  Eigen::Vector3f extent_m = Eigen::Vector3f::Zero();
  std::vector<int> points;  ///< indices into the cloud, ascending
  /// The points thinned to one in half a cluster distance, m: the object's shape for matching and display.
  std::vector<Eigen::Vector3f> outline_in_lidar;
};

/// Objects of a scan. `up_in_lidar` is the direction away from the ground, unit length; where the mounting is not
/// known, estimate_up finds it.
std::vector<SceneObject> find_objects(const PointCloud& cloud_in_lidar, const Eigen::Vector3f& up_in_lidar,
                                      const ObjectOptions& options);

/// Direction away from the ground from the dominant plane below the sensor (RANSAC, fixed seed), for a sensor that is
/// mounted in any orientation. `hint` (unit length) breaks ties; zero for none. Falls back to the hint, or to +z.
Eigen::Vector3f estimate_up(const PointCloud& cloud_in_lidar, const Eigen::Vector3f& hint);

/// The ground near a sensor.
struct GroundPlane {
  Eigen::Vector3f up_in_lidar = Eigen::Vector3f::UnitZ();  ///< away from the ground, unit length
  float sensor_height_m = 0.0f;                            ///< of the lidar's origin above the plane
  bool found = false;                                      ///< false: nothing like ground is seen; up is the fallback
};

/// The plane that estimate_up finds, and the height above it; not `found` where no plane below holds enough points.
GroundPlane estimate_ground_plane(const PointCloud& cloud_in_lidar, const Eigen::Vector3f& hint);

/// True for each point on the ground.
std::vector<bool> ground_mask(const PointCloud& cloud_in_lidar, const Eigen::Vector3f& up_in_lidar,
                              const ObjectOptions& options);

struct ObjectMatch {
  std::size_t object_a = 0;
  std::size_t object_b = 0;
  bool moving = false;          ///< displaced against the rest of the pair
  double displacement_m = 0.0;  ///< against the rest of the pair
};

/// One-to-one association of the objects of scan a with those of scan b, each where it is predicted by
/// `lidar_b_from_lidar_a` (from INS motion and the mounting) and alike in size and shape. The rest of the pair's
/// common displacement (median) is taken out before an object is called moving.
std::vector<ObjectMatch> match_objects(const std::vector<SceneObject>& objects_a,
                                       const std::vector<SceneObject>& objects_b,
                                       const RigidTransform& lidar_b_from_lidar_a, const ObjectOptions& options);

}  // namespace remount::cloud
