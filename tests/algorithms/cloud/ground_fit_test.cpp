#include "algorithms/cloud/ground_fit.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "algorithms/geometry/rigid_transform.h"
#include "algorithms/geometry/shortest_rotation.h"

namespace remount::cloud {
namespace {

// Rings of a sensor 1.8 m above a road, with a wall and a parked box beside it, seen from a sensor that leans.
PointCloud street(const RigidTransform& lidar_from_level) {
  std::mt19937 random(1);
  std::normal_distribution<double> noise(0.0, 0.01);
  PointCloud cloud;
  const auto add = [&](double x, double y, double z) {
    cloud.points.push_back((lidar_from_level * Eigen::Vector3d(x, y, z + noise(random))).cast<float>());
  };
  for (double radius = 4.0; radius < 30.0; radius *= 1.12)
    for (double angle = 0.0; angle < 6.28; angle += 0.01) add(radius * std::cos(angle), radius * std::sin(angle), -1.8);
  for (double x = -5.0; x < 5.0; x += 0.1)
    for (double z = -1.8; z < 0.5; z += 0.1) {
      add(x, 7.0, z);
      add(x, -6.0, z);
    }
  return cloud;
}

TEST(ground_fit, finds_the_plane_below_a_leaning_sensor_between_walls) {
  const RigidTransform lidar_from_level =
      make_rigid(rotation_from_yaw_pitch_roll({0.4, 0.1, -0.15}), Eigen::Vector3d::Zero());
  const auto fit = fit_ground(street(lidar_from_level), Eigen::Vector3f::UnitZ(), {}, 12.0);
  ASSERT_TRUE(fit);
  EXPECT_NEAR(fit->lidar_height_m, 1.8, 0.01);
  const Eigen::Vector3d up_in_lidar = lidar_from_level.linear() * Eigen::Vector3d::UnitZ();
  EXPECT_LT(so3_log(shortest_rotation(fit->up_in_lidar, up_in_lidar)).norm(), 0.004);
}

TEST(ground_fit, an_empty_scan_and_a_strip_to_the_left_give_none) {
  EXPECT_FALSE(fit_ground({}, Eigen::Vector3f::UnitZ(), {}, 12.0));
  PointCloud strip;
  for (double x = 0.0; x < 10.0; x += 0.02) strip.points.emplace_back(static_cast<float>(x), 4.2f, -1.8f);
  EXPECT_FALSE(fit_ground(strip, Eigen::Vector3f::UnitZ(), {}, 12.0));
}

// Even ground 1.8 m below the sensor wherever `seen` says so.
template <class Seen>
PointCloud ground_where(const Seen& seen) {
  PointCloud cloud;
  for (float x = -12.0f; x < 12.0f; x += 0.2f)
    for (float y = -12.0f; y < 12.0f; y += 0.2f)
      if (std::hypot(x, y) > 3.0f && seen(x, y)) cloud.points.emplace_back(x, y, -1.8f);
  return cloud;
}

TEST(ground_fit, ground_on_one_side_only_gives_none) {
  const auto fit = [](const auto& seen) {
    return fit_ground(ground_where(seen), Eigen::Vector3f::UnitZ(), {}, 12.0).has_value();
  };
  for (const float turn_rad : {0.0f, 0.4f, 0.8f, 2.5f, 4.0f}) {
    const float c = std::cos(turn_rad), s = std::sin(turn_rad);
    EXPECT_FALSE(fit([&](float x, float y) { return c * x + s * y > 0.0f; })) << "half plane towards " << turn_rad;
    EXPECT_FALSE(fit([&](float x, float y) { return c * x + s * y > 5.0f && c * x + s * y < 9.0f; }))
        << "strip towards " << turn_rad;
    EXPECT_TRUE(fit([&](float x, float y) { return c * x + s * y > 0.0f || c * y - s * x > 0.0f; }))
        << "three quadrants, from " << turn_rad;
  }
  EXPECT_TRUE(fit([](float, float) { return true; }));
}

}  // namespace
}  // namespace remount::cloud
