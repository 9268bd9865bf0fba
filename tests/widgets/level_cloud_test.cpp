#include "widgets/scene/level_cloud.h"

#include <gtest/gtest.h>

#include <array>
#include <limits>
#include <random>
#include <set>
#include <stop_token>

#include "widgets/scene/frame_budget.h"

namespace remount::widgets {
namespace {

/// A wide ground, dense near the middle as around a sensor, and a wall.
std::vector<Eigen::Vector3f> uneven_cloud(std::size_t size) {
  std::mt19937 random(3);
  std::normal_distribution<float> near(0.0F, 3.0F);
  std::uniform_real_distribution<float> wide(-80.0F, 80.0F);
  std::vector<Eigen::Vector3f> points;
  for (std::size_t i = 0; i < size; ++i) {
    if (i % 4 == 0)
      points.emplace_back(wide(random), wide(random), 0.01F * near(random));
    else if (i % 4 == 1)
      points.emplace_back(wide(random), 20.0F, 0.05F * wide(random) + 4.0F);
    else
      points.emplace_back(near(random), near(random), 0.01F * near(random));
  }
  return points;
}

using Voxel = std::array<long, 3>;
std::set<Voxel> voxels(const std::vector<Eigen::Vector3f>& points, std::size_t count, float edge_m) {
  std::set<Voxel> found;
  for (std::size_t i = 0; i < count; ++i)
    found.insert({std::lround(std::floor(points[i].x() / edge_m)), std::lround(std::floor(points[i].y() / edge_m)),
                  std::lround(std::floor(points[i].z() / edge_m))});
  return found;
}

TEST(level_cloud, holds_every_good_point_once) {
  std::vector<Eigen::Vector3f> points = uneven_cloud(5000);
  const float nan = std::numeric_limits<float>::quiet_NaN();
  points.insert(points.begin() + 7, {Eigen::Vector3f(nan, 0, 0), Eigen::Vector3f(1e30F, 0, 0)});
  points.push_back(points[3]);
  const scene::LevelCloud cloud = scene::order_by_levels(points);
  EXPECT_EQ(cloud.left_out, 2U);
  ASSERT_EQ(cloud.size(), points.size() - 2);
  ASSERT_EQ(cloud.original.size(), cloud.size());
  std::set<std::uint32_t> seen(cloud.original.begin(), cloud.original.end());
  EXPECT_EQ(seen.size(), cloud.size());
  for (std::size_t i = 0; i < cloud.size(); ++i) EXPECT_EQ(cloud.points[i], points[cloud.original[i]]);
  ASSERT_EQ(cloud.level_end.back(), cloud.size());
  EXPECT_EQ(cloud.level_end.size(), cloud.level_edge_m.size());
}

TEST(level_cloud, each_level_has_a_point_for_every_voxel_that_holds_any) {
  const std::vector<Eigen::Vector3f> points = uneven_cloud(200000);
  const scene::LevelCloud cloud = scene::order_by_levels(points);
  int compared = 0;
  for (std::size_t level = 0; level < cloud.level_end.size(); ++level) {
    const std::size_t count = cloud.level_end[level];
    if (count > 20000 || count < 50) continue;
    // Voxels of the same size on another grid: an edge twice as long cannot fall between the points of the level.
    const float edge_m = 2.0F * cloud.level_edge_m[level];
    const auto all = voxels(points, points.size(), edge_m), some = voxels(cloud.points, count, edge_m);
    EXPECT_GT(some.size(), 0.8 * all.size()) << "level " << level;
    std::printf("level %zu: %zu points show %zu of %zu voxels of %.2f m\n", level, count, some.size(), all.size(),
                edge_m);
    ++compared;
  }
  EXPECT_GE(compared, 3);
}

TEST(level_cloud, any_beginning_shows_the_whole_evenly) {
  const std::vector<Eigen::Vector3f> points = uneven_cloud(200000);
  const scene::LevelCloud cloud = scene::order_by_levels(points);
  const std::size_t count = 5000;  // in the middle of a level
  const auto all = voxels(points, points.size(), 10.0F).size();
  const auto ordered = voxels(cloud.points, count, 10.0F).size();
  std::vector<Eigen::Vector3f> first(points.begin(), points.begin() + static_cast<std::ptrdiff_t>(count));
  EXPECT_GT(static_cast<double>(ordered), 0.97 * static_cast<double>(all));
  // A plain thinning spends half of its points on the dense middle.
  const auto dense = [](const std::vector<Eigen::Vector3f>& some, std::size_t n) {
    std::size_t inside = 0;
    for (std::size_t i = 0; i < n; ++i) inside += some[i].head<2>().norm() < 6.0F;
    return inside;
  };
  EXPECT_LT(dense(cloud.points, count), dense(first, count) / 3);
}

TEST(level_cloud, empty_bad_and_cancelled_clouds_are_empty) {
  EXPECT_EQ(scene::order_by_levels({}).size(), 0U);
  const float nan = std::numeric_limits<float>::quiet_NaN();
  EXPECT_EQ(scene::order_by_levels({Eigen::Vector3f(nan, nan, nan)}).left_out, 1U);
  EXPECT_EQ(scene::order_by_levels({Eigen::Vector3f(1, 2, 3)}).size(), 1U);
  EXPECT_EQ(scene::order_by_levels(std::vector<Eigen::Vector3f>(100, Eigen::Vector3f(1, 2, 3))).size(), 100U);
  std::stop_source stop;
  stop.request_stop();
  EXPECT_EQ(scene::order_by_levels(uneven_cloud(1000), Progress(stop.get_token())).size(), 0U);
}

TEST(frame_budget, finds_the_number_of_points_that_the_machine_can_draw) {
  for (const double seconds_per_point : {2e-8, 4e-7, 3e-6}) {
    scene::FrameBudget budget;
    for (int frame = 0; frame < 30; ++frame)
      budget.took(budget.points(), 1e-4 + seconds_per_point * static_cast<double>(budget.points()));
    const double frame_s = seconds_per_point * static_cast<double>(budget.points());
    if (budget.points() > scene::FrameBudget::kFewest)
      EXPECT_NEAR(frame_s, scene::FrameBudget::kTarget_s, 0.1 * scene::FrameBudget::kTarget_s);
    else
      EXPECT_GE(frame_s, 0.9 * scene::FrameBudget::kTarget_s) << "a cloud is never thinned to nothing";
    EXPECT_NEAR(budget.seconds_for(1000000), 1e6 * seconds_per_point, 0.2 * 1e6 * seconds_per_point);
  }
}

TEST(frame_budget, what_a_frame_costs_without_points_is_not_blamed_on_them) {
  scene::FrameBudget budget;
  const double fixed_s = 0.08, seconds_per_point = 2e-7;
  for (int frame = 0; frame < 40; ++frame) {
    const std::size_t points = frame % 4 ? budget.points() : budget.points() / 3;
    budget.took(points, fixed_s + seconds_per_point * static_cast<double>(points));
  }
  EXPECT_NEAR(seconds_per_point * static_cast<double>(budget.points()), 0.5 * scene::FrameBudget::kTarget_s,
              0.1 * scene::FrameBudget::kTarget_s);
}

TEST(frame_budget, one_slow_frame_does_not_empty_the_view) {
  scene::FrameBudget budget;
  const std::size_t before = budget.points();
  budget.took(before, 3.0);
  EXPECT_GE(budget.points(), before / 2);
}

}  // namespace
}  // namespace remount::widgets
