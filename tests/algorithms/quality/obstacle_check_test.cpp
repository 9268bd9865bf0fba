#include "algorithms/quality/obstacle_check.h"

#include <gtest/gtest.h>

#include "algorithms/core/error.h"

namespace remount::quality {
namespace {

using Eigen::Vector3d;
using Eigen::Vector3f;

/// Upright posts of points at given places of the INS frame, seen by a lidar with a given mounting; one object each.
struct Posts {
  cloud::PointCloud cloud;
  std::vector<cloud::SceneObject> objects;

  Posts(const std::vector<Vector3d>& feet_in_vehicle, const RigidTransform& vehicle_from_lidar) {
    for (const Vector3d& foot : feet_in_vehicle) {
      cloud::SceneObject object;
      for (int i = 0; i < 10; ++i) {
        object.points.push_back(static_cast<int>(cloud.size()));
        cloud.points.push_back((vehicle_from_lidar.inverse() * (foot + Vector3d(0.0, 0.0, 0.1 * i))).cast<float>());
        object.centroid_in_lidar += cloud.points.back() / 10.0f;
      }
      object.shape = cloud::ObjectShape::Pole;
      objects.push_back(object);
    }
  }
};

const RigidTransform kScannerMounting = rigid_from_six({0.9, -0.2, 0.8, 1.6, -0.05, 0.03});

TEST(obstacle_check, measures_from_the_sides_and_from_the_corners_of_the_outline) {
  // Outline: x -1.5 to 3.5, y -1 to 1.
  const Posts posts({{6.5, 0.0, 0.0}, {0.0, 2.0, 0.0}, {-4.5, -5.0, 0.0}}, kScannerMounting);
  const ObstacleCheck found = check_obstacles(posts.cloud, posts.objects, kScannerMounting, {});
  ASSERT_EQ(found.obstacles.size(), 3u);
  EXPECT_EQ(found.obstacles[0].object, 1);
  EXPECT_NEAR(found.obstacles[0].distance_m, 1.0, 1e-5) << "beside";
  EXPECT_NEAR(found.obstacles[1].distance_m, 3.0, 1e-5) << "ahead";
  EXPECT_NEAR(found.obstacles[2].distance_m, 5.0, 1e-5) << "from the corner: 3, 4, 5";
  EXPECT_NEAR(found.nearest_m, 1.0, 1e-5);
  EXPECT_NEAR((found.obstacles[0].centroid_in_vehicle - Vector3d(0.0, 2.0, 0.45)).norm(), 0.0, 1e-5);
}

TEST(obstacle_check, decides_by_the_preset_distance) {
  const Posts posts({{6.0, 0.0, 0.0}}, kScannerMounting);
  ObstacleOptions options;
  options.stop_distance_m = 2.6;
  EXPECT_EQ(check_obstacles(posts.cloud, posts.objects, kScannerMounting, options).decision, ObstacleDecision::Stop);
  options.stop_distance_m = 2.4;
  EXPECT_EQ(check_obstacles(posts.cloud, posts.objects, kScannerMounting, options).decision, ObstacleDecision::Clear);
}

TEST(obstacle_check, a_wrong_mounting_changes_the_decision_and_the_comparison_shows_it) {
  const Posts posts({{6.0, 0.0, 0.0}, {0.0, 8.0, 0.0}}, kScannerMounting);
  RigidTransform nominal = kScannerMounting;
  nominal.translation().x() += 1.0;  // believed a metre farther ahead than it is
  ObstacleOptions options;
  options.stop_distance_m = 3.0;
  const ObstacleComparison both = compare_obstacles(posts.cloud, posts.objects, nominal, kScannerMounting, options);
  EXPECT_TRUE(both.decision_differs());
  EXPECT_EQ(both.nominal.decision, ObstacleDecision::Clear);
  EXPECT_EQ(both.calibrated.decision, ObstacleDecision::Stop);
  ASSERT_EQ(both.rows.size(), 2u);
  EXPECT_NEAR(both.rows[0].nominal_distance_m - both.rows[0].calibrated_distance_m, 1.0, 1e-5);
  EXPECT_NEAR(both.rows[1].nominal_distance_m, both.rows[1].calibrated_distance_m, 1e-5)
      << "beside, forward does not matter";
}

TEST(obstacle_check, the_vehicle_itself_and_what_hangs_above_are_no_obstacles) {
  const Posts posts({{1.0, 0.0, 0.0}, {5.0, 0.0, 4.0}, {3.5, 1.0, 0.0}}, kScannerMounting);
  ObstacleOptions options;
  EXPECT_EQ(check_obstacles(posts.cloud, {posts.objects[0], posts.objects[1]}, kScannerMounting, options).decision,
            ObstacleDecision::Clear);
  options.ignore_inside = false;
  const ObstacleCheck strict = check_obstacles(posts.cloud, posts.objects, kScannerMounting, options);
  EXPECT_EQ(strict.decision, ObstacleDecision::Stop);
  EXPECT_EQ(strict.nearest_m, 0.0);
}

TEST(obstacle_check, no_objects_is_clear) {
  const ObstacleCheck found = check_obstacles({}, {}, kScannerMounting, {});
  EXPECT_EQ(found.decision, ObstacleDecision::Clear);
  EXPECT_TRUE(std::isinf(found.nearest_m));
}

TEST(obstacle_check, refuses_an_empty_outline_and_objects_of_another_scan) {
  ObstacleOptions options;
  options.outline_x_min_m = 4.0;
  EXPECT_THROW(check_obstacles({}, {}, kScannerMounting, options), Error);
  cloud::SceneObject stray;
  stray.points = {7};
  EXPECT_THROW(check_obstacles({}, {stray}, kScannerMounting, {}), Error);
}

}  // namespace
}  // namespace remount::quality
