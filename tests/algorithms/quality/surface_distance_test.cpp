#include "algorithms/quality/surface_distance.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stop_token>

namespace remount::quality {
namespace {

/// A wall at x = 10 m, in rows 0.2 m apart as a spinning sensor leaves them.
cloud::PointCloud ringed_wall() {
  cloud::PointCloud cloud;
  for (int row = 0; row < 20; ++row)
    for (int i = 0; i < 200; ++i) cloud.points.emplace_back(10.0F, -5.0F + 0.05F * i, -2.0F + 0.2F * row);
  return cloud;
}

TEST(surface_distance, between_the_rings_of_a_wall_is_on_the_wall) {
  const SurfaceDistance wall(ringed_wall());
  const std::vector<float> distances =
      wall.of({{10.0F, 0.02F, 0.1F}, {10.07F, 1.0F, 0.1F}, {9.8F, -1.0F, 0.3F}}, RigidTransform::Identity());
  ASSERT_EQ(distances.size(), 3U);
  EXPECT_NEAR(distances[0], 0.0F, 1e-4F);
  EXPECT_NEAR(distances[1], 0.07F, 1e-3F);
  EXPECT_NEAR(distances[2], 0.2F, 1e-3F);
  std::printf("distances %.4f %.4f %.4f m\n", distances[0], distances[1], distances[2]);
}

TEST(surface_distance, follows_the_transform) {
  const SurfaceDistance wall(ringed_wall());
  const RigidTransform target_from_source = rigid_from_six({0.5, 0.0, 0.0, 0.5 * kPi, 0.0, 0.0});
  // In the target at (0.5 + 9.8, 0, 0).
  EXPECT_NEAR(wall.of({{0.0F, -9.8F, 0.0F}}, target_from_source)[0], 0.3F, 1e-3F);
}

TEST(surface_distance, nothing_near_and_nothing_finite_is_not_a_number) {
  const SurfaceDistance wall(ringed_wall());
  const float nan = std::numeric_limits<float>::quiet_NaN();
  for (const float distance : wall.of({{5.0F, 0.0F, 0.0F}, {nan, 0.0F, 0.0F}, {1e30F, 0.0F, 0.0F}, {8.9F, 0.0F, 0.0F}},
                                      RigidTransform::Identity()))
    EXPECT_TRUE(std::isnan(distance)) << distance;
  const SurfaceDistance nothing(cloud::PointCloud{});
  EXPECT_TRUE(std::isnan(nothing.of({{5.0F, 0.0F, 0.0F}}, RigidTransform::Identity())[0]));
  EXPECT_TRUE(wall.of({}, RigidTransform::Identity()).empty());
}

TEST(surface_distance, bad_points_of_the_target_change_nothing) {
  cloud::PointCloud cloud = ringed_wall();
  cloud.points.emplace_back(1e30F, 0.0F, 0.0F);
  cloud.points.emplace_back(std::numeric_limits<float>::quiet_NaN(), 0.0F, 0.0F);
  EXPECT_NEAR(SurfaceDistance(cloud).of({{10.07F, 1.0F, 0.1F}}, RigidTransform::Identity())[0], 0.07F, 1e-3F);
}

TEST(surface_distance, cancelled_leaves_nothing) {
  const SurfaceDistance wall(ringed_wall());
  std::stop_source stop;
  stop.request_stop();
  EXPECT_TRUE(wall.of({{10.0F, 0.0F, 0.0F}}, RigidTransform::Identity(), Progress(stop.get_token())).empty());
}

TEST(median_distance, leaves_out_what_is_not_a_number) {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  EXPECT_FLOAT_EQ(median_distance_m({nan, 0.3F, 0.1F, nan, 0.2F}), 0.2F);
  EXPECT_TRUE(std::isnan(median_distance_m({nan})));
}

}  // namespace
}  // namespace remount::quality
