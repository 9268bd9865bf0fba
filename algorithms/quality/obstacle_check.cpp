#include "algorithms/quality/obstacle_check.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "algorithms/core/error.h"
#include "algorithms/core/index.h"
#include "messages/parameters.h"

namespace remount::quality {

namespace {

void check(const ObstacleOptions& options) {
  std::vector<Message> problems = option_problems(options);
  if (!(options.outline_x_min_m < options.outline_x_max_m)) problems.push_back(say::outline_rear_front());
  if (!(options.outline_y_min_m < options.outline_y_max_m)) problems.push_back(say::outline_right_left());
  if (!problems.empty()) throw Error(ErrorCode::Contract, "obstacle check", in_one(std::move(problems)));
}

/// Distance in the plane from the outline; 0 within it.
double distance_m(const Eigen::Vector3d& p, const ObstacleOptions& options) {
  const double dx = std::max({options.outline_x_min_m - p.x(), p.x() - options.outline_x_max_m, 0.0});
  const double dy = std::max({options.outline_y_min_m - p.y(), p.y() - options.outline_y_max_m, 0.0});
  return std::hypot(dx, dy);
}

/// Nothing where the object is no obstacle.
std::optional<Obstacle> obstacle(const cloud::PointCloud& cloud, const cloud::SceneObject& object,
                                 const RigidTransform& vehicle_from_lidar, const ObstacleOptions& options) {
  Obstacle result;
  result.shape = object.shape;
  result.distance_m = std::numeric_limits<double>::infinity();
  result.centroid_in_vehicle = vehicle_from_lidar * object.centroid_in_lidar.cast<double>();
  bool any_outside = false;
  for (const int i : object.points) {
    if (i < 0 || static_cast<std::size_t>(i) >= cloud.size())
      throw Error(ErrorCode::Contract, "obstacle check", Message::verbatim("the objects are not those of this scan"));
    const Eigen::Vector3d p = vehicle_from_lidar * cloud.points[index_at(i)].cast<double>();
    if (p.z() > options.clearance_above_m) continue;
    const double distance = distance_m(p, options);
    any_outside = any_outside || distance > 0.0;
    if (distance >= result.distance_m) continue;
    result.distance_m = distance;
    result.nearest_point_in_vehicle = p;
  }
  if (!std::isfinite(result.distance_m) || (options.ignore_inside && !any_outside)) return std::nullopt;
  return result;
}

}  // namespace

std::string_view to_string(ObstacleDecision decision) { return decision == ObstacleDecision::Stop ? "stop" : "clear"; }

ObstacleCheck check_obstacles(const cloud::PointCloud& cloud_in_lidar, const std::vector<cloud::SceneObject>& objects,
                              const RigidTransform& vehicle_from_lidar, const ObstacleOptions& options) {
  check(options);
  ObstacleCheck result;
  for (std::size_t i = 0; i < objects.size(); ++i) {
    std::optional<Obstacle> found = obstacle(cloud_in_lidar, objects[i], vehicle_from_lidar, options);
    if (!found) continue;
    found->object = static_cast<int>(i);
    result.obstacles.push_back(*found);
  }
  std::stable_sort(result.obstacles.begin(), result.obstacles.end(),
                   [](const Obstacle& a, const Obstacle& b) { return a.distance_m < b.distance_m; });
  if (!result.obstacles.empty()) result.nearest_m = result.obstacles.front().distance_m;
  result.decision = result.nearest_m < options.stop_distance_m ? ObstacleDecision::Stop : ObstacleDecision::Clear;
  return result;
}

ObstacleComparison compare_obstacles(const cloud::PointCloud& cloud_in_lidar,
                                     const std::vector<cloud::SceneObject>& objects,
                                     const RigidTransform& nominal_vehicle_from_lidar,
                                     const RigidTransform& calibrated_vehicle_from_lidar,
                                     const ObstacleOptions& options) {
  ObstacleComparison result;
  result.nominal = check_obstacles(cloud_in_lidar, objects, nominal_vehicle_from_lidar, options);
  result.calibrated = check_obstacles(cloud_in_lidar, objects, calibrated_vehicle_from_lidar, options);
  std::vector<ObstacleDifference> rows(objects.size());
  std::vector<bool> used(objects.size(), false);
  const auto enter = [&](const ObstacleCheck& check, double ObstacleDifference::*distance) {
    for (const Obstacle& found : check.obstacles) {
      ObstacleDifference& row = rows[index_at(found.object)];
      row.object = found.object;
      row.shape = found.shape;
      row.*distance = found.distance_m;
      used[index_at(found.object)] = true;
    }
  };
  enter(result.nominal, &ObstacleDifference::nominal_distance_m);
  enter(result.calibrated, &ObstacleDifference::calibrated_distance_m);
  for (std::size_t i = 0; i < rows.size(); ++i)
    if (used[i]) result.rows.push_back(rows[i]);
  return result;
}

}  // namespace remount::quality
