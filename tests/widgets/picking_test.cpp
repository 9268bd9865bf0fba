#include "widgets/scene/picking.h"

#include <gtest/gtest.h>

#include <limits>
#include <random>
#include <stop_token>

#include "widgets/scene/distance_scale.h"
#include "widgets/scene/point_grid.h"

namespace remount::widgets {
namespace {

scene::PickRay along_x() {
  scene::PickRay ray;
  ray.origin_in_view = {-10.0, 0.0, 0.0};
  ray.pixel_rad = 1e-3;
  return ray;
}

TEST(picking, takes_the_point_nearest_to_the_ray_by_angle) {
  // At 20 m 2 cm are a milliradian, a pixel; at 10 m 3 cm are three.
  const std::vector<Eigen::Vector3f> points{{0.0F, 0.03F, 0.0F}, {10.0F, 0.0F, 0.02F}, {10.0F, 0.1F, 0.0F}};
  const auto picked = scene::nearest_to_ray(points, RigidTransform::Identity(), along_x());
  ASSERT_TRUE(picked);
  EXPECT_EQ(picked->index, 1U);
  EXPECT_NEAR(picked->angle_rad, 1e-3, 1e-6);
  EXPECT_NEAR(picked->distance_m, 20.0, 1e-6);
}

TEST(picking, of_points_that_look_like_one_takes_the_one_in_front) {
  const std::vector<Eigen::Vector3f> points{{30.0F, 0.0F, 0.0F}, {5.0F, 0.005F, 0.0F}, {4.0F, 0.05F, 0.0F}};
  const auto picked = scene::nearest_to_ray(points, RigidTransform::Identity(), along_x());
  ASSERT_TRUE(picked);
  EXPECT_EQ(picked->index, 1U);
}

TEST(picking, follows_the_transform_of_the_cloud) {
  const RigidTransform view_from_cloud = rigid_from_six({3.0, 0.0, 0.0, 0.5 * kPi, 0.0, 0.0});
  // (0, -7, 0) of the cloud is at (3 + 7, 0, 0) of the view.
  const std::vector<Eigen::Vector3f> points{{7.0F, 0.0F, 0.0F}, {0.0F, -7.0F, 0.0F}};
  const auto picked = scene::nearest_to_ray(points, view_from_cloud, along_x());
  ASSERT_TRUE(picked);
  EXPECT_EQ(picked->index, 1U);
  EXPECT_NEAR(picked->distance_m, 20.0, 1e-6);
}

TEST(picking, nothing_near_behind_or_bad_is_picked) {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const std::vector<Eigen::Vector3f> points{
      {-30.0F, 0.0F, 0.0F}, {0.0F, 1.0F, 0.0F}, {nan, 0.0F, 0.0F}, {-10.0F, 0.0F, 0.0F}};
  EXPECT_FALSE(scene::nearest_to_ray(points, RigidTransform::Identity(), along_x()));
  EXPECT_FALSE(scene::nearest_to_ray({}, RigidTransform::Identity(), along_x()));
}

/// A street of a kilometre: ground, facades, and a few stray points.
std::vector<Eigen::Vector3f> street(std::size_t count) {
  std::mt19937 random(9);
  std::uniform_real_distribution<float> unit(0.0F, 1.0F);
  std::vector<Eigen::Vector3f> points;
  for (std::size_t i = 0; i < count; ++i) {
    const float along = 1000.0F * unit(random), kind = unit(random);
    points.emplace_back(along,
                        kind < 0.6F   ? 24.0F * (unit(random) - 0.5F)
                        : kind < 0.8F ? 12.0F
                                      : -12.0F,
                        kind < 0.6F ? 0.0F : 9.0F * unit(random));
    if (i % 20000 == 0) points.back() *= 40.0F;
  }
  return points;
}

TEST(point_grid, finds_what_a_search_through_all_points_finds_and_looks_at_few) {
  const std::vector<Eigen::Vector3f> points = street(200000);
  const scene::PointGrid grid(points, {});
  std::mt19937 random(2);
  std::uniform_real_distribution<double> unit(-1.0, 1.0);
  std::size_t most = 0;
  int hits = 0;
  for (int i = 0; i < 60; ++i) {
    scene::PickRay ray;
    ray.origin_in_view = {500.0 + 600.0 * unit(random), 300.0 * unit(random), 150.0 + 140.0 * unit(random)};
    const Eigen::Vector3d target = points[random() % points.size()].cast<double>();
    const Eigen::Vector3d off = Eigen::Vector3d(unit(random), unit(random), unit(random)) * (i % 4 ? 0.5 : 60.0);
    ray.direction_in_view = (target + off - ray.origin_in_view).normalized();
    ray.pixel_rad = 1e-3;
    const auto all = scene::nearest_to_ray(points, RigidTransform::Identity(), ray),
               found = grid.nearest_to_ray(points, ray);
    ASSERT_EQ(all.has_value(), found.has_value()) << i;
    if (!all) continue;
    ++hits;
    EXPECT_NEAR(all->distance_m, found->distance_m, 1e-6) << i;
    EXPECT_EQ(all->index, found->index) << i;
    most = std::max(most, grid.looked_at());
  }
  EXPECT_GT(hits, 30);
  EXPECT_LT(most, points.size() / 8) << "of twice as many that a search through all looks at";
}

TEST(point_grid, holds_nothing_where_there_is_nothing_or_it_was_cancelled) {
  EXPECT_FALSE(scene::PointGrid({}, {}).nearest_to_ray({}, along_x()));
  const std::vector<Eigen::Vector3f> one{{10.0F, 0.0F, 0.0F}};
  EXPECT_TRUE(scene::PointGrid(one, {}).nearest_to_ray(one, along_x()));
  std::stop_source stop;
  stop.request_stop();
  EXPECT_FALSE(scene::PointGrid(one, Progress(stop.get_token())).nearest_to_ray(one, along_x()));
}

TEST(distance_scale, has_a_colour_of_its_own_beyond_its_end_and_for_nothing) {
  const scene::DistanceScale scale(0.2);
  EXPECT_EQ(scale.color(0.0F), scene::DistanceScale::at(0.0));
  EXPECT_EQ(scale.color(0.1F), scene::DistanceScale::at(0.5));
  EXPECT_EQ(scale.color(0.1999F), scene::DistanceScale::at(0.9995));
  EXPECT_EQ(scale.color(0.2001F), scene::DistanceScale::kOverRange);
  EXPECT_EQ(scale.color(std::numeric_limits<float>::quiet_NaN()), scene::DistanceScale::kNothingNear);
  EXPECT_EQ(scene::DistanceScale(-1.0).limit_m(), scene::DistanceScale::kLeast_m);
  EXPECT_EQ(scene::DistanceScale(std::numeric_limits<double>::quiet_NaN()).limit_m(), scene::DistanceScale::kDefault_m);
  for (const scene::SceneColor& other : {scene::DistanceScale::kOverRange, scene::DistanceScale::kNothingNear})
    for (double share = 0.0; share <= 1.0; share += 0.01) {
      const scene::SceneColor on_scale = scene::DistanceScale::at(share);
      int apart = 0;
      for (std::size_t i = 0; i < 3; ++i) apart += std::abs(on_scale[i] - other[i]);
      EXPECT_GT(apart, 80) << "at " << share;
    }
}

}  // namespace
}  // namespace remount::widgets
