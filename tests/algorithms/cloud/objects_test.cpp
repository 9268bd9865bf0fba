// Objects in recorded scans. Laws that need known truth are tested on the simulator
// (tests/model/simulator/objects_test.cpp).
#include "algorithms/cloud/objects.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <filesystem>
#include <fstream>
#include <limits>

#include "tests/support/sanitized.h"

namespace remount::cloud {
namespace {

using Eigen::Vector3f;

/// The velodyne scans of one drive; empty where the data are absent.
std::vector<std::filesystem::path> scans_of(const std::string& drive) {
  std::vector<std::filesystem::path> files;
  const std::filesystem::path folder = std::filesystem::path(REMOUNT_SOURCE_DIR) / "../shared/data/kitti" / drive;
  if (!std::filesystem::is_directory(folder)) return files;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder))
    if (entry.path().extension() == ".bin") files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  return files;
}

PointCloud load(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  PointCloud cloud;
  std::array<float, 4> record{};
  while (in.read(reinterpret_cast<char*>(record.data()), sizeof(record)))
    cloud.points.push_back({record[0], record[1], record[2]});
  return cloud;
}

TEST(objects_of_broken_scans, points_far_away_or_not_finite_are_no_objects_and_do_no_harm) {
  PointCloud cloud;
  const float inf = std::numeric_limits<float>::infinity(), nan = std::numeric_limits<float>::quiet_NaN();
  for (int i = 0; i < 100; ++i) {
    cloud.points.push_back({1e30f, -1e30f, 1e20f});
    cloud.points.push_back({inf, 0.0f, 0.0f});
    cloud.points.push_back({nan, nan, nan});
    cloud.points.push_back({1e-30f, 0.0f, 0.0f});
  }
  EXPECT_EQ(ground_mask(cloud, Vector3f::UnitZ(), {}).size(), cloud.size());
  for (const SceneObject& object : find_objects(cloud, Vector3f::UnitZ(), {}))
    EXPECT_TRUE(object.centroid_in_lidar.allFinite());
  EXPECT_TRUE(estimate_up(cloud, Vector3f::Zero()).allFinite());
}

TEST(objects_of_broken_scans, extreme_options_need_bounded_memory) {
  ObjectOptions options;
  options.cluster_distance_m = 0.05;
  options.max_range_m = 500.0;
  options.ground_cell_m = 0.2;
  options.min_points = 3;
  PointCloud cloud;
  for (int i = 0; i < 50; ++i)
    cloud.points.push_back({0.02f * static_cast<float>(i), 5.0f, 0.02f * static_cast<float>(i)});
  EXPECT_LE(find_objects(cloud, Vector3f::UnitZ(), options).size(), 50u);
}

class objects_of_recorded_scans : public ::testing::TestWithParam<const char*> {};

TEST_P(objects_of_recorded_scans, up_is_within_a_slope_of_the_sensors_axis) {
  const auto files = scans_of(GetParam());
  if (files.empty()) GTEST_SKIP() << "shared data are absent";
  for (const auto& file : files) {
    const Vector3f up = estimate_up(load(file), Vector3f::Zero());
    EXPECT_LT(std::acos(std::min(1.0f, up.z())) * 57.3f, 4.0f) << file << ": " << up.transpose();
  }
}

TEST_P(objects_of_recorded_scans, most_objects_are_found_again_in_the_next_scan_and_few_move) {
  const auto files = scans_of(GetParam());
  if (files.size() < 2) GTEST_SKIP() << "shared data are absent";
  const ObjectOptions options;
  std::size_t found = 0, matched = 0, moving = 0;
  for (std::size_t i = 0; i + 1 < files.size(); ++i) {
    const PointCloud a = load(files[i]), b = load(files[i + 1]);
    const auto objects_a = find_objects(a, Vector3f::UnitZ(), options),
               objects_b = find_objects(b, Vector3f::UnitZ(), options);
    // Ten scans a second and at most 10 m/s: without a prediction objects are within a metre of where they were.
    const auto matches = match_objects(objects_a, objects_b, RigidTransform::Identity(), options);
    found += std::min(objects_a.size(), objects_b.size());
    matched += matches.size();
    moving += static_cast<std::size_t>(
        std::count_if(matches.begin(), matches.end(), [](const ObjectMatch& m) { return m.moving; }));
    EXPECT_GE(objects_a.size(), 20u) << files[i];
  }
  RecordProperty("matched",
                 std::to_string(matched) + " of " + std::to_string(found) + ", moving " + std::to_string(moving));
  EXPECT_GT(static_cast<double>(matched), 0.6 * static_cast<double>(found));
  // The vehicle of drive 10 turns: without a prediction all that is far away seems to move there.
  if (std::string(GetParam()) != "10") {
    EXPECT_LT(static_cast<double>(moving), 0.08 * static_cast<double>(matched)) << moving << " of " << matched;
  }
}

TEST_P(objects_of_recorded_scans, are_found_quickly) {
  const auto files = scans_of(GetParam());
  if (files.empty()) GTEST_SKIP() << "shared data are absent";
  double best_ms = 1e9;
  for (int i = 0; i < 3; ++i) {
    const PointCloud cloud = load(files[0]);
    const auto before = std::chrono::steady_clock::now();
    const auto objects = find_objects(cloud, Vector3f::UnitZ(), {});
    best_ms =
        std::min(best_ms, std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - before).count());
    ASSERT_FALSE(objects.empty());
  }
  RecordProperty("ms", std::to_string(best_ms));
  EXPECT_LT(best_ms, 300.0 * testing::kSanitizerSlowdown) << "ten times what it takes on one core";
}

INSTANTIATE_TEST_SUITE_P(Kitti, objects_of_recorded_scans, ::testing::Values("00", "05", "07", "10"));

}  // namespace
}  // namespace remount::cloud
