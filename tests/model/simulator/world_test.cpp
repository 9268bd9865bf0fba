#include "model/simulator/world.h"

#include <gtest/gtest.h>

#include "model/simulator/random_stream.h"
#include "model/simulator/road.h"

namespace remount::simulator {
namespace {

using Eigen::Vector3d;

Ray ray_towards(const Vector3d& from, const Vector3d& to) { return {from, (to - from).normalized()}; }

TEST(world, ray_meets_flat_ground_where_the_line_does) {
  const World world(Ground({}), {}, {});
  const Ray ray = ray_towards({1.0, 2.0, 3.0}, {11.0, -4.0, 0.0});
  EXPECT_NEAR(world.cast(ray, 100.0).distance_m, Vector3d(10.0, -6.0, -3.0).norm(), 1e-12);
  EXPECT_FALSE(world.cast(ray, 10.0).found()) << "beyond the longest range";
  EXPECT_FALSE(world.cast(ray_towards({0.0, 0.0, 1.0}, {1.0, 0.0, 1.5}), 100.0).found()) << "upwards";
}

TEST(world, ray_meets_turned_box_where_its_face_is) {
  Box box;
  box.centre = {10.0, 5.0};
  box.yaw_rad = 0.4;
  box.half = {3.0, 1.0};
  box.bottom_m = -1.0;
  box.top_m = 4.0;
  const World world(Ground({}), {box}, {});
  // A point on the face at -half.y, and a ray that comes from outside that face.
  const Eigen::Rotation2Dd turn(box.yaw_rad);
  for (const double along : {-2.9, -1.0, 0.0, 2.9}) {
    const Eigen::Vector2d on_face = box.centre + turn * Eigen::Vector2d(along, -1.0);
    const Eigen::Vector2d outside = box.centre + turn * Eigen::Vector2d(along - 1.5, -8.0);
    const Vector3d from(outside.x(), outside.y(), 1.5), to(on_face.x(), on_face.y(), 2.0);
    EXPECT_NEAR(world.cast(ray_towards(from, to), 50.0).distance_m, (to - from).norm(), 1e-9) << "along " << along;
  }
}

TEST(world, ray_meets_cylinder_at_its_near_side) {
  Cylinder pole;
  pole.centre = {6.0, 0.0};
  pole.radius_m = 0.2;
  pole.top_m = 3.0;
  const World world(Ground({}), {}, {pole});
  EXPECT_NEAR(world.cast({{0.0, 0.0, 1.0}, Vector3d::UnitX()}, 50.0).distance_m, 5.8, 1e-12);
  EXPECT_NEAR(world.cast({{0.0, 0.1, 1.0}, Vector3d::UnitX()}, 50.0).distance_m, 6.0 - std::sqrt(0.04 - 0.01), 1e-12);
  EXPECT_FALSE(world.cast({{0.0, 0.21, 1.0}, Vector3d::UnitX()}, 50.0).found());
  EXPECT_FALSE(world.cast({{0.0, 0.0, 3.1}, Vector3d::UnitX()}, 50.0).found()) << "above its top";
}

TEST(world, nearest_of_many_objects_is_what_all_of_them_give) {
  RandomStream random(3, 0);
  std::vector<Box> boxes;
  for (int i = 0; i < 60; ++i) {
    Box box;
    box.centre = {random.uniform(-40.0, 40.0), random.uniform(-40.0, 40.0)};
    box.yaw_rad = random.uniform(0.0, 6.0);
    box.half = {random.uniform(0.2, 5.0), random.uniform(0.2, 2.0)};
    box.bottom_m = -1.0;
    box.top_m = random.uniform(0.5, 6.0);
    boxes.push_back(box);
  }
  const World world(Ground({}), boxes, {});
  for (int i = 0; i < 5000; ++i) {
    const Ray ray{{random.uniform(-60.0, 60.0), random.uniform(-60.0, 60.0), 1.7},
                  (random.normal3().cwiseProduct(Vector3d(1.0, 1.0, 0.2))).normalized()};
    RayHit expected;
    expected.distance_m = 80.0;
    for (const Box& box : boxes) BoxCaster(box).cast(ray, 1.0 / ray.direction.z(), expected);
    const double ground_m = ray.direction.z() < 0.0 ? -ray.origin.z() / ray.direction.z() : 1e9;
    const RayHit found = world.cast(ray, 80.0);
    ASSERT_NEAR(found.found() ? found.distance_m : 80.0, std::min(expected.distance_m, ground_m), 1e-9) << "ray " << i;
  }
}

TEST(world, ray_meets_undulating_ground_first_where_it_first_dips_below) {
  const Ground ground = scenario_ground(ScenarioKind::Street, 5);
  RandomStream random(4, 0);
  double worst_m = 0.0;
  int hits = 0;
  for (int i = 0; i < 2000; ++i) {
    const double x = random.uniform(-200.0, 200.0), y = random.uniform(-200.0, 200.0),
                 azimuth = random.uniform(0.0, 6.28);
    const double down = random.uniform(0.02, 0.45);
    const Ray ray{{x, y, ground.surface_height_m(x, y) + 1.6},
                  Vector3d(std::cos(azimuth) * std::cos(down), std::sin(azimuth) * std::cos(down), -std::sin(down))};
    double expected = Ground::kNoHit;
    for (double t = 0.0; t < 80.0; t += 0.01) {
      const Vector3d p = ray.origin + t * ray.direction;
      if (p.z() > ground.surface_height_m(p.x(), p.y())) continue;
      expected = t;
      break;
    }
    const double found = ground.cast(ray, 80.0);
    if (expected == Ground::kNoHit) continue;
    ++hits;
    const Vector3d p = ray.origin + found * ray.direction;
    ASSERT_LT(std::abs(p.z() - ground.surface_height_m(p.x(), p.y())), 0.004) << "ray " << i << ", at " << found;
    // A ray that skims a crest by less than 4 mm may be stopped there.
    if (std::abs(found - expected) < 0.011) continue;
    ASSERT_LT(found, expected) << "ray " << i << " passed through the ground";
    worst_m = std::max(worst_m, expected - found);
  }
  EXPECT_GT(hits, 1500);
  RecordProperty("skimming rays stopped early by, m", std::to_string(worst_m));
}

TEST(world, smooth_ground_and_the_surface_that_rays_hit_agree_within_a_centimetre) {
  const Ground ground = scenario_ground(ScenarioKind::Street, 1);
  double worst_m = 0.0;
  for (double x = -90.0; x < 90.0; x += 0.73)
    for (double y = -90.0; y < 90.0; y += 0.71)
      worst_m = std::max(worst_m, std::abs(ground.height_m(x, y) - ground.surface_height_m(x, y)));
  EXPECT_LT(worst_m, 0.01);
}

}  // namespace
}  // namespace remount::simulator
