#include "algorithms/quality/map_sharpness.h"

#include <gtest/gtest.h>

#include <random>

namespace remount::quality {
namespace {

const RigidTransform kMapTruth = rigid_from_six({1.0, 0.3, 1.5, 0.2, 0.02, -0.03});

// Walls and ground of a yard, sampled at random from poses of a vehicle that turns and leans.
MapScans mapped_yard() {
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> along(-10.0, 10.0), up(0.0, 4.0);
  std::normal_distribution<double> noise(0.0, 0.01);
  MapScans map;
  for (int scan = 0; scan < 8; ++scan) {
    map.local_from_ins.push_back(
        rigid_from_six({0.8 * scan, 0.2 * scan, 0.5, 0.15 * scan, 0.03 * std::sin(scan), 0.03 * std::cos(2.0 * scan)}));
    const RigidTransform lidar_from_local = (map.local_from_ins.back() * kMapTruth).inverse();
    auto& points = map.points_in_lidar.emplace_back();
    for (int i = 0; i < 3000; ++i) {
      const double a = along(random), b = up(random), n = noise(random);
      const Eigen::Vector3d p = i % 3 == 0   ? Eigen::Vector3d(a, 10.0 + n, b)
                                : i % 3 == 1 ? Eigen::Vector3d(10.0 + n, a, b)
                                             : Eigen::Vector3d(a, along(random), n);
      points.push_back((lidar_from_local * p).cast<float>());
    }
  }
  return map;
}

TEST(map_sharpness, is_best_under_the_truth_and_shows_the_thickness_of_the_walls) {
  const std::vector<RigidTransform> candidates{
      kMapTruth, perturb(kMapTruth, 0.1 * Vector6d::Unit(0)), perturb(kMapTruth, 0.1 * Vector6d::Unit(1)),
      perturb(kMapTruth, 0.02 * Vector6d::Unit(5)), perturb(kMapTruth, 0.02 * Vector6d::Unit(3))};
  const auto found = compare_sharpness({mapped_yard()}, candidates, {}, 1, {});
  ASSERT_GT(found[0].points, 500U);
  EXPECT_NEAR(found[0].plane_thickness_m, 0.01, 0.004);
  for (std::size_t i = 1; i < found.size(); ++i) {
    EXPECT_GT(found[i].mean_map_entropy, found[0].mean_map_entropy + 0.05) << "candidate " << i;
    EXPECT_GT(found[i].plane_thickness_m, 1.2 * found[0].plane_thickness_m) << "candidate " << i;
    EXPECT_EQ(found[i].points, found[0].points);
  }
}

TEST(map_sharpness, is_the_same_for_any_number_of_threads) {
  const auto one = compare_sharpness({mapped_yard()}, {kMapTruth}, {}, 1, {}),
             three = compare_sharpness({mapped_yard()}, {kMapTruth}, {}, 3, {});
  EXPECT_EQ(one[0].mean_map_entropy, three[0].mean_map_entropy);
  EXPECT_EQ(one[0].plane_thickness_m, three[0].plane_thickness_m);
}

TEST(map_sharpness, without_overlap_or_scans_there_is_none) {
  MapScans alone = mapped_yard();
  alone.points_in_lidar.resize(1);
  alone.local_from_ins.resize(1);
  EXPECT_TRUE(std::isnan(compare_sharpness({alone}, {kMapTruth}, {}, 1, {})[0].mean_map_entropy));
  EXPECT_TRUE(std::isnan(compare_sharpness({}, {kMapTruth}, {}, 1, {})[0].mean_map_entropy));
  EXPECT_TRUE(compare_sharpness({alone}, {}, {}, 1, {}).empty());
}

}  // namespace
}  // namespace remount::quality
