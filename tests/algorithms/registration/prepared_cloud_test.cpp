#include "algorithms/registration/prepared_cloud.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include "algorithms/geometry/rotation.h"
#include "tests/algorithms/support/room.h"

namespace remount::registration {
namespace {

cloud::PointCloud room_scan() { return testing::scan_of(testing::room(), RigidTransform::Identity(), 0.005, 1, 6000); }

TEST(prepared_cloud, nearest_is_that_of_a_search_through_all_and_stays_within_its_reach) {
  const PreparedCloud cloud(room_scan(), {});
  ASSERT_GT(cloud.size(), 1000U);
  std::mt19937_64 random(2);
  std::uniform_real_distribution<float> x(-12, 12), y(-8, 8), z(-3, 5);
  int found_some = 0, found_none = 0;
  for (int i = 0; i < 500; ++i) {
    const Eigen::Vector3f query(x(random), y(random), z(random));
    for (const float radius_m : {0.3f, 2.0f}) {
      std::vector<std::pair<float, int>> distances_m;
      for (std::size_t k = 0; k < cloud.size(); ++k)
        distances_m.emplace_back((cloud.point(k) - query).norm(), static_cast<int>(k));
      std::partial_sort(distances_m.begin(), distances_m.begin() + 2, distances_m.end());
      const Neighbour found = cloud.nearest(query, radius_m);
      if (distances_m[0].first > radius_m) {
        EXPECT_EQ(found.index, -1);
        ++found_none;
        continue;
      }
      ++found_some;
      EXPECT_EQ(found.index, distances_m[0].second);
      EXPECT_NEAR(found.distance_m, distances_m[0].first, 1e-5f);
      EXPECT_LE(found.reach_m, 0.5f * (distances_m[1].first - distances_m[0].first));
      EXPECT_GE(found.reach_m + 1e-4f, 0.5f * (std::min(radius_m, distances_m[1].first) - distances_m[0].first));
    }
  }
  EXPECT_GT(found_some, 100);
  EXPECT_GT(found_none, 100);
}

TEST(prepared_cloud, normals_are_unit_length_face_the_sensor_and_are_those_of_the_walls) {
  const PreparedCloud cloud(room_scan(), {});
  std::size_t on_walls = 0;
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    EXPECT_NEAR(cloud.normal(i).norm(), 1.0f, 1e-4f);
    EXPECT_LE(cloud.normal(i).dot(cloud.point(i)), 1e-5f);
    EXPECT_GE(cloud.planarity(i), 0.0f);
    EXPECT_LE(cloud.planarity(i), 1.0f);
    if (cloud.normal(i).cwiseAbs().maxCoeff() > 0.99f) ++on_walls;
  }
  EXPECT_GT(on_walls, cloud.size() * 7 / 10) << "of " << cloud.size();
}

// Rings on level ground, as far apart as a sparse sensor's, with noise of range.
cloud::PointCloud rings_on_the_ground(const std::vector<double>& radii_m) {
  constexpr double kHeight_m = 2.0, kNoise_m = 0.03, kStep_rad = 0.006;
  std::mt19937_64 random(7);
  std::normal_distribution<double> noise(0.0, kNoise_m);
  cloud::PointCloud cloud;
  for (const double radius_m : radii_m)
    for (double azimuth_rad = 0.0; azimuth_rad < 2.0 * kPi; azimuth_rad += kStep_rad) {
      const Eigen::Vector3d hit(radius_m * std::cos(azimuth_rad), radius_m * std::sin(azimuth_rad), -kHeight_m);
      cloud.points.push_back((hit + noise(random) * hit.normalized()).cast<float>());
    }
  return cloud;
}

TEST(prepared_cloud, one_ring_is_no_surface_and_two_are_the_ground) {
  // Its second direction is the noise along the rays, so a plane through it would lean with them.
  EXPECT_EQ(PreparedCloud(rings_on_the_ground({12.0}), {}).size(), 0U);
  const PreparedCloud ground(rings_on_the_ground({12.0, 13.0}), {});
  ASSERT_GT(ground.size(), 300U);
  double steepest_rad = 0.0;
  for (std::size_t i = 0; i < ground.size(); ++i)
    steepest_rad = std::max(steepest_rad, std::acos(std::min(1.0, static_cast<double>(ground.normal(i).z()))));
  EXPECT_LT(radians_to_degrees(steepest_rad), 3.0);
}

TEST(prepared_cloud, keeps_the_range_limits_and_leaves_out_moving_points) {
  RegistrationOptions options;
  options.min_range_m = 3.0;
  options.max_range_m = 8.0;
  const cloud::PointCloud scan = room_scan();
  std::vector<bool> left_out(scan.size());
  for (std::size_t i = 0; i < scan.size(); ++i) left_out[i] = scan.points[i].x() > 0.0f;
  const PreparedCloud cloud(scan, options, left_out);
  ASSERT_GT(cloud.size(), 100U);
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    const Eigen::Vector3f point = cloud.point(i);
    EXPECT_LT(point.x(), 1e-6f);
    EXPECT_GT(point.norm(), 2.9f);
    EXPECT_LT(point.norm(), 8.1f);
  }
}

TEST(prepared_cloud, scans_without_a_surface_are_empty_not_errors) {
  EXPECT_EQ(PreparedCloud({}, {}).size(), 0U);
  cloud::PointCloud line;  // one beam on far ground
  for (int i = 0; i < 200; ++i) line.points.emplace_back(10.0f, -20.0f + 0.3f * static_cast<float>(i), -1.5f);
  EXPECT_EQ(PreparedCloud(line, {}).size(), 0U);
  EXPECT_EQ(PreparedCloud(line, {}).nearest({0, 0, 0}, 5.0f).index, -1);
  cloud::PointCloud few;
  for (int i = 0; i < 13; ++i) few.points.emplace_back(5.0f + static_cast<float>(i), static_cast<float>(i % 4), 0.0f);
  EXPECT_EQ(PreparedCloud(few, {}).size(), 0U);
}

TEST(prepared_cloud, is_the_same_bit_for_bit_from_both_builds_of_the_loops) {
  if (!has_fast_kernels()) GTEST_SKIP() << "this processor has no AVX2";
  RegistrationOptions portable;
  portable.instructions = InstructionSet::Portable;
  const PreparedCloud first(room_scan(), {}), second(room_scan(), portable);
  ASSERT_EQ(first.size(), second.size());
  for (std::size_t i = 0; i < first.size(); ++i) {
    EXPECT_EQ(first.point(i), second.point(i));
    EXPECT_EQ(first.normal(i), second.normal(i));
    EXPECT_EQ(first.planarity(i), second.planarity(i));
  }
}

TEST(prepared_cloud, leaves_out_points_that_are_not_finite) {
  cloud::PointCloud cloud = room_scan();
  const PreparedCloud clean(cloud, {});
  const float nan = std::numeric_limits<float>::quiet_NaN(), infinite = std::numeric_limits<float>::infinity();
  for (const Eigen::Vector3f& bad : {Eigen::Vector3f(nan, 1, 1), Eigen::Vector3f(2, 2, infinite),
                                     Eigen::Vector3f(-infinite, nan, 3), Eigen::Vector3f(3e38f, 3e38f, 3e38f)})
    cloud.points.push_back(bad);
  EXPECT_EQ(PreparedCloud(cloud, {}).copy_points(), clean.copy_points());
}

TEST(prepared_cloud, cancelled_is_empty) {
  std::stop_source stop;
  stop.request_stop();
  EXPECT_EQ(PreparedCloud(room_scan(), {}, {}, Progress(stop.get_token())).size(), 0U);
}

}  // namespace
}  // namespace remount::registration
