// Scans of simple surroundings made of rectangles, each scan with its own sample of points and its own noise.
#pragma once

#include <random>
#include <vector>

#include "algorithms/cloud/point_cloud.h"
#include "algorithms/geometry/rigid_transform.h"

namespace remount::testing {

struct Rectangle {
  Eigen::Vector3d corner, side_a, side_b;  // m, world
};

inline std::vector<Rectangle> room() {
  return {{{-10, -6, -1.5}, {20, 0, 0}, {0, 12, 0}},  // floor
          {{-10, -6, -1.5}, {20, 0, 0}, {0, 0, 5}},   // walls
          {{-10, 6, -1.5}, {20, 0, 0}, {0, 0, 5}},    //
          {{-10, -6, -1.5}, {0, 12, 0}, {0, 0, 5}},   //
          {{10, -6, -1.5}, {0, 12, 0}, {0, 0, 5}},    //
          {{4, 3, -1.5}, {2, 1, 0}, {0, 0, 3}},       // slanted boards
          {{-6, -4, -1.5}, {1, 2, 0}, {0, 0, 3}}};
}

/// Floor and two walls, alike wherever one stands along x.
inline std::vector<Rectangle> corridor() {
  return {{{-30, -3, -1.5}, {60, 0, 0}, {0, 6, 0}},
          {{-30, -3, -1.5}, {60, 0, 0}, {0, 0, 4}},
          {{-30, 3, -1.5}, {60, 0, 0}, {0, 0, 4}}};
}

inline cloud::PointCloud scan_of(const std::vector<Rectangle>& world, const RigidTransform& world_from_lidar,
                                 double noise_m, int seed, int points = 12000) {
  std::mt19937_64 random(static_cast<std::uint64_t>(seed));
  std::uniform_real_distribution<double> along(0.0, 1.0);
  std::normal_distribution<double> noise(0.0, 1.0);
  double total_area = 0.0;
  for (const Rectangle& rectangle : world) total_area += rectangle.side_a.cross(rectangle.side_b).norm();
  cloud::PointCloud cloud;
  for (const Rectangle& rectangle : world) {
    const Eigen::Vector3d area = rectangle.side_a.cross(rectangle.side_b);
    const int count = static_cast<int>(points * area.norm() / total_area);
    for (int i = 0; i < count; ++i) {
      const double a = along(random), b = along(random);
      const Eigen::Vector3d on = rectangle.corner + a * rectangle.side_a + b * rectangle.side_b;
      const Eigen::Vector3d point_in_world = on + noise_m * noise(random) * area.normalized();
      cloud.points.push_back((world_from_lidar.inverse() * point_in_world).cast<float>());
    }
  }
  return cloud;
}

}  // namespace remount::testing
