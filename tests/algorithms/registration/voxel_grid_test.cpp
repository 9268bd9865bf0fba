#include "algorithms/registration/voxel_grid.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <tuple>

namespace remount::registration {
namespace {

TEST(voxel_centroids, are_the_means_of_their_voxels_in_the_order_of_their_first_points) {
  EXPECT_TRUE(voxel_centroids({}, 1.0f).empty());
  const std::vector<Eigen::Vector3f> centroids =
      voxel_centroids({{0.1f, 0.1f, 0.1f}, {0.5f, 0.3f, 0.1f}, {-0.1f, 0.1f, 0.1f}, {0.2f, 0.2f, 1.5f}}, 1.0f);
  ASSERT_EQ(centroids.size(), 3U);
  EXPECT_TRUE(centroids[0].isApprox(Eigen::Vector3f(0.3f, 0.2f, 0.1f)));
  EXPECT_TRUE(centroids[1].isApprox(Eigen::Vector3f(-0.1f, 0.1f, 0.1f)));
  EXPECT_TRUE(centroids[2].isApprox(Eigen::Vector3f(0.2f, 0.2f, 1.5f)));
}

TEST(voxel_centroids, do_not_depend_on_the_order_of_the_points_nor_on_how_many_there_are) {
  std::mt19937_64 random(3);
  std::uniform_real_distribution<float> place(-20.0f, 20.0f);
  std::vector<Eigen::Vector3f> points(200000);  // more voxels than the table starts with
  for (Eigen::Vector3f& point : points) point = {place(random), place(random), 0.02f * place(random)};
  const auto sorted = [](std::vector<Eigen::Vector3f> centroids) {
    const auto cell = [](const Eigen::Vector3f& p) {
      return std::tuple(std::floor(p.z() / 0.2f), std::floor(p.y() / 0.2f), std::floor(p.x() / 0.2f));
    };
    std::sort(centroids.begin(), centroids.end(), [&](const auto& a, const auto& b) { return cell(a) < cell(b); });
    return centroids;
  };
  const std::vector<Eigen::Vector3f> first = sorted(voxel_centroids(points, 0.2f));
  std::shuffle(points.begin(), points.end(), random);
  const std::vector<Eigen::Vector3f> second = sorted(voxel_centroids(points, 0.2f));
  ASSERT_GT(first.size(), 50000U);
  ASSERT_EQ(first.size(), second.size());
  std::size_t different = 0;  // centroids on a voxel's edge may change places
  for (std::size_t i = 0; i < first.size(); ++i) different += (first[i] - second[i]).norm() > 1e-5f ? 1 : 0;
  EXPECT_LT(different, first.size() / 1000);
}

TEST(voxel_centroids, far_points_do_not_wrap_around) {
  // 2^21 voxels away: the first that an index of 21 bits would take for a neighbour.
  const std::vector<Eigen::Vector3f> centroids =
      voxel_centroids({{2097152.5f, 0.5f, 0.5f}, {0.5f, 1.5f, 0.5f}, {-3e6f, 0.5f, 0.5f}}, 1.0f);
  EXPECT_EQ(centroids.size(), 3U);
}

}  // namespace
}  // namespace remount::registration
