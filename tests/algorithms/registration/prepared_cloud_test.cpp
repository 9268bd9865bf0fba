#include "algorithms/registration/prepared_cloud.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "tests/algorithms/support/room.h"

namespace remount {
namespace {

PointCloud room_scan() { return scan_of(room(), RigidTransform::Identity(), 0.005, 1, 6000); }

TEST(PreparedCloud, NearestIsThatOfASearchThroughAllAndSoIsTheNextDistance) {
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
        distances_m.emplace_back((cloud.points()[k] - query).norm(), static_cast<int>(k));
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
      EXPECT_NEAR(found.next_distance_m, std::min(radius_m, distances_m[1].first), 1e-5f);
    }
  }
  EXPECT_GT(found_some, 100);
  EXPECT_GT(found_none, 100);
}

TEST(PreparedCloud, NormalsAreUnitLengthFaceTheSensorAndAreThoseOfTheWalls) {
  const PreparedCloud cloud(room_scan(), {});
  std::size_t on_walls = 0;
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    EXPECT_NEAR(cloud.normals()[i].norm(), 1.0f, 1e-4f);
    EXPECT_LE(cloud.normals()[i].dot(cloud.points()[i]), 1e-5f);
    EXPECT_GE(cloud.planarity()[i], 0.0f);
    EXPECT_LE(cloud.planarity()[i], 1.0f);
    if (cloud.normals()[i].cwiseAbs().maxCoeff() > 0.99f) ++on_walls;
  }
  EXPECT_GT(on_walls, cloud.size() * 7 / 10) << "of " << cloud.size();
}

TEST(PreparedCloud, KeepsTheRangeLimitsAndLeavesOutMovingPoints) {
  RegistrationOptions options;
  options.min_range_m = 3.0;
  options.max_range_m = 8.0;
  const PointCloud scan = room_scan();
  std::vector<bool> left_out(scan.size());
  for (std::size_t i = 0; i < scan.size(); ++i) left_out[i] = scan.points[i].x() > 0.0f;
  const PreparedCloud cloud(scan, options, left_out);
  ASSERT_GT(cloud.size(), 100U);
  for (const Eigen::Vector3f& point : cloud.points()) {
    EXPECT_LT(point.x(), 1e-6f);
    EXPECT_GT(point.norm(), 2.9f);
    EXPECT_LT(point.norm(), 8.1f);
  }
}

TEST(PreparedCloud, ScansWithoutASurfaceAreEmptyNotErrors) {
  EXPECT_EQ(PreparedCloud({}, {}).size(), 0U);
  PointCloud line;  // one beam on far ground
  for (int i = 0; i < 200; ++i) line.points.emplace_back(10.0f, -20.0f + 0.3f * static_cast<float>(i), -1.5f);
  EXPECT_EQ(PreparedCloud(line, {}).size(), 0U);
  EXPECT_EQ(PreparedCloud(line, {}).nearest({0, 0, 0}, 5.0f).index, -1);
  PointCloud few;
  for (int i = 0; i < 13; ++i) few.points.emplace_back(5.0f + static_cast<float>(i), static_cast<float>(i % 4), 0.0f);
  EXPECT_EQ(PreparedCloud(few, {}).size(), 0U);
}

TEST(VoxelCentroids, AreTheMeansOfTheirVoxelsInAnOrderThatDoesNotDependOnThePoints) {
  EXPECT_TRUE(voxel_centroids({}, 1.0f).empty());
  const std::vector<Eigen::Vector3f> centroids =
      voxel_centroids({{0.1f, 0.1f, 0.1f}, {0.5f, 0.3f, 0.1f}, {-0.1f, 0.1f, 0.1f}, {0.2f, 0.2f, 1.5f}}, 1.0f);
  ASSERT_EQ(centroids.size(), 3U);
  EXPECT_TRUE(centroids[0].isApprox(Eigen::Vector3f(-0.1f, 0.1f, 0.1f)));
  EXPECT_TRUE(centroids[1].isApprox(Eigen::Vector3f(0.3f, 0.2f, 0.1f)));
  EXPECT_TRUE(centroids[2].isApprox(Eigen::Vector3f(0.2f, 0.2f, 1.5f)));

  std::vector<Eigen::Vector3f> points = room_scan().points;
  const std::vector<Eigen::Vector3f> first = voxel_centroids(points, 0.5f);
  std::mt19937_64 random(3);
  std::shuffle(points.begin(), points.end(), random);
  const std::vector<Eigen::Vector3f> second = voxel_centroids(points, 0.5f);
  ASSERT_EQ(first.size(), second.size());
  for (std::size_t i = 0; i < first.size(); ++i) EXPECT_LT((first[i] - second[i]).norm(), 1e-5f) << i;
}

TEST(VoxelCentroids, FarPointsDoNotWrapAround) {
  // 2^21 voxels away: the first that an index of 21 bits would take for a neighbour.
  const std::vector<Eigen::Vector3f> centroids =
      voxel_centroids({{2097152.5f, 0.5f, 0.5f}, {0.5f, 1.5f, 0.5f}, {-3e6f, 0.5f, 0.5f}}, 1.0f);
  EXPECT_EQ(centroids.size(), 3U);
}

}  // namespace
}  // namespace remount
