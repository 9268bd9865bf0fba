#include "algorithms/odometry/fusion/feature_extraction.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/algorithms/odometry/synthetic_drive.h"

namespace remount::odometry {
namespace {

// A room: floor, two walls that meet at (8, 6), and a pole.
synthetic::Drive room(double range_noise_m) {
  synthetic::Drive drive;
  drive.world.walls = {{{0, 0, 0}, {0, 0, 1}, {1, 0, 0}},
                       {{8, 0, 3}, {-1, 0, 0}, {0, 1, 0}, 6.0, 3.0},
                       {{0, 6, 3}, {0, -1, 0}, {1, 0, 0}, 8.0, 3.0}};
  drive.world.poles = {{{4.0, -3.0}, 0.1}};
  drive.distorted = false;
  drive.azimuths = 1000;
  drive.mounting.vehicle_from_lidar = make_rigid(Eigen::Matrix3d::Identity(), {0.0, 0.0, 1.8});
  drive.noise.range_m = range_noise_m;
  return drive;
}

double off_the_edges_m(const Eigen::Vector3f& point) {
  const Eigen::Vector2f at = point.head<2>();
  const float floor = point.z() + 1.8f;
  const double corner = (at - Eigen::Vector2f(8, 6)).norm(), pole = (at - Eigen::Vector2f(4, -3)).norm() - 0.1;
  const double wall_ends = std::min((at - Eigen::Vector2f(8, -6)).norm(), (at - Eigen::Vector2f(-8, 6)).norm());
  const double at_floor = std::hypot(floor, std::min(std::abs(at.x() - 8.0f), std::abs(at.y() - 6.0f)));
  return std::min({corner, std::abs(pole), wall_ends, at_floor});
}

double off_the_planes_m(const Eigen::Vector3f& point) {
  return std::min({std::abs(point.z() + 1.8f), std::abs(point.x() - 8.0f), std::abs(point.y() - 6.0f)});
}

TEST(features, lines_lie_at_edges_and_planes_on_surfaces) {
  const ScanFeatures features = extract_features(room(0.01).scan(0).cloud_in_lidar, {});
  EXPECT_GT(features.lines.size(), 20u);
  EXPECT_GT(features.planes.size(), 200u);
  const auto stray_lines = std::count_if(features.lines.begin(), features.lines.end(),
                                         [](const Eigen::Vector3f& point) { return off_the_edges_m(point) > 0.2; });
  const auto stray_planes = std::count_if(features.planes.begin(), features.planes.end(),
                                          [](const Eigen::Vector3f& point) { return off_the_planes_m(point) > 0.05; });
  EXPECT_LE(static_cast<double>(stray_lines), 0.1 * static_cast<double>(features.lines.size()));
  EXPECT_LE(static_cast<double>(stray_planes), 0.03 * static_cast<double>(features.planes.size()));
}

TEST(features, a_smooth_wall_has_no_lines) {
  synthetic::Drive drive = room(0.015);
  drive.world = synthetic::tunnel();
  const ScanFeatures features = extract_features(drive.scan(0).cloud_in_lidar, {});
  EXPECT_GT(features.planes.size(), 500u);
  // Where walls meet floor and ceiling there are some; none across the tunnel.
  for (const Eigen::Vector3f& line : features.lines) {
    const double to_wall = std::min(std::abs(line.y() - 5.0f), std::abs(line.y() + 4.0f));
    const double to_floor = std::min(std::abs(line.z() + 1.8f), std::abs(line.z() - 4.2f));
    EXPECT_LT(std::hypot(to_wall, to_floor), 0.4) << line.transpose();
  }
}

TEST(features, off_the_chord_does_not_see_uneven_spacing) {
  std::vector<Eigen::Vector3f> straight, bent;
  for (int i = -5; i <= 5; ++i) {
    const float along = static_cast<float>(i < 0 ? -i * i : 2 * i) * 0.1f;
    straight.push_back({5.0f + along, 2.0f - along, 1.0f});
    bent.push_back({std::abs(static_cast<float>(i)), static_cast<float>(i), 0.0f});
  }
  EXPECT_LT(off_chord_m(straight, 5), 1e-5f);
  EXPECT_NEAR(off_chord_m(bent, 5), 3.0f, 1e-5f);  // the mean of 1..5
}

TEST(features, beams_are_found_by_ring_by_order_and_by_elevation) {
  const synthetic::Drive drive = room(0.0);
  const cloud::PointCloud by_ring = drive.scan(0).cloud_in_lidar;
  const auto beams = points_by_beam(by_ring);
  EXPECT_EQ(beams.size(), static_cast<std::size_t>(drive.beams));
  cloud::PointCloud by_order;
  for (const auto& beam : beams) by_order.points.insert(by_order.points.end(), beam.begin(), beam.end());
  EXPECT_EQ(points_by_beam(by_order).size(), beams.size());
  cloud::PointCloud unordered;
  unordered.points = by_ring.points;  // column by column
  const auto rows = points_by_beam(unordered);
  EXPECT_GE(rows.size(), 10u);
  std::size_t total = 0;
  for (const auto& row : rows) total += row.size();
  EXPECT_EQ(total, by_ring.size());
}

TEST(features, near_and_far_points_are_left_out) {
  FusionOptions options;
  options.min_range_m = 5.0;
  options.max_range_m = 7.0;
  for (const Eigen::Vector3f& point : extract_features(room(0.0).scan(0).cloud_in_lidar, options).planes) {
    EXPECT_GT(point.norm(), 4.6f);
    EXPECT_LT(point.norm(), 7.1f);
  }
  EXPECT_TRUE(extract_features({}, {}).planes.empty());
}

}  // namespace
}  // namespace remount::odometry
