#include "algorithms/cloud/deskew.h"

#include <gtest/gtest.h>

#include "algorithms/core/error.h"

namespace remount::cloud {
namespace {

using Eigen::Vector3d;

/// A vehicle that turns and accelerates: world_from_lidar at a time.
RigidTransform world_from_lidar(double t) {
  const Vector3d turn(0.02 * t, 0.05 * t, 0.8 * t + 0.5 * t * t);
  return make_rigid(so3_exp(turn), {12.0 * t + 1.5 * t * t, 0.3 * t, 0.1 * t});
}

RigidTransform at_stamp_from_at(double t) { return world_from_lidar(0.0).inverse() * world_from_lidar(t); }

/// Points that stand in the world in a ring, each measured at the time a clockwise sensor of period_s faces it.
PointCloud measured_ring(double period_s, std::vector<Vector3d>& at_stamp) {
  PointCloud cloud;
  for (int i = 0; i < 720; ++i) {
    const double turn = (i + 0.5) / 720.0 - 0.5, azimuth = -2.0 * kPi * turn, range_m = 5.0 + i % 70;
    const Vector3d in_lidar(range_m * std::cos(azimuth), range_m * std::sin(azimuth), 0.1 * (i % 9));
    cloud.points.push_back(in_lidar.cast<float>());
    cloud.time_from_stamp_s.push_back(static_cast<float>(turn * period_s));
    cloud.ring.push_back(static_cast<std::uint16_t>(i % 9));
    at_stamp.push_back(at_stamp_from_at(turn * period_s) * in_lidar);
  }
  return cloud;
}

double worst_m(const PointCloud& cloud, const std::vector<Vector3d>& expected) {
  double worst = 0.0;
  for (std::size_t i = 0; i < expected.size(); ++i)
    worst = std::max(worst, (cloud.points[i].cast<double>() - expected[i]).norm());
  return worst;
}

TEST(deskew, takes_every_point_to_the_stamp) {
  std::vector<Vector3d> expected;
  const PointCloud cloud = measured_ring(0.1, expected);
  EXPECT_GT(worst_m(cloud, expected), 1.0) << "the motion of the test is too small to mean anything";
  const PointCloud compensated = deskew(cloud, cloud.time_from_stamp_s, at_stamp_from_at);
  EXPECT_LT(worst_m(compensated, expected), 1e-4);
  EXPECT_EQ(compensated.ring, cloud.ring);
  EXPECT_TRUE(compensated.time_from_stamp_s.empty()) << "could be compensated twice";
}

TEST(deskew, times_from_the_azimuth_are_those_of_the_points) {
  std::vector<Vector3d> expected;
  const PointCloud cloud = measured_ring(0.1, expected);
  const std::vector<float> times_s = sweep_times(cloud, 0.1, 0.0, true);
  for (std::size_t i = 0; i < cloud.size(); ++i) ASSERT_NEAR(times_s[i], cloud.time_from_stamp_s[i], 1e-7);
  const std::vector<float> other_way_s = sweep_times(cloud, 0.1, 0.0, false);
  for (std::size_t i = 0; i < cloud.size(); ++i) ASSERT_NEAR(other_way_s[i], -cloud.time_from_stamp_s[i], 1e-7);
}

TEST(deskew, azimuth_at_the_stamp_has_time_zero_and_the_seam_is_opposite) {
  PointCloud cloud;
  cloud.points = {{-1.0f, 0.001f, 0.0f}, {1.0f, 0.01f, 0.0f}, {1.0f, -0.01f, 0.0f}, {0.0f, 1.0f, 0.0f}};
  const std::vector<float> times_s = sweep_times(cloud, 0.1, kPi, true);
  EXPECT_NEAR(times_s[0], 0.0, 1e-4);
  EXPECT_NEAR(std::abs(times_s[1]), 0.05, 2e-4);
  EXPECT_NEAR(std::abs(times_s[2]), 0.05, 2e-4);
  EXPECT_LT(times_s[1] * times_s[2], 0.0f);
  EXPECT_NEAR(times_s[3], 0.025, 1e-6) << "clockwise from the back the sensor faces left a quarter of a turn later";
}

TEST(deskew, motion_is_asked_for_rarely) {
  std::vector<Vector3d> expected;
  const PointCloud cloud = measured_ring(0.1, expected);
  int calls = 0;
  deskew(cloud, cloud.time_from_stamp_s, [&](double t) {
    ++calls;
    return at_stamp_from_at(t);
  });
  EXPECT_LE(calls, 60);
}

TEST(deskew, empty_and_instantaneous_scans_pass) {
  EXPECT_EQ(deskew({}, {}, at_stamp_from_at).size(), 0u);
  PointCloud cloud;
  cloud.points = {{1.0f, 2.0f, 3.0f}};
  const std::vector<float> times_s{0.0f};
  EXPECT_LT((deskew(cloud, times_s, at_stamp_from_at).points[0] - cloud.points[0]).norm(), 1e-6f);
}

TEST(deskew, refuses_times_that_cannot_be) {
  PointCloud cloud;
  cloud.points = {{1.0f, 2.0f, 3.0f}, {1.0f, 2.0f, 4.0f}};
  const std::vector<float> few{0.0f}, broken{0.0f, std::numeric_limits<float>::quiet_NaN()}, wide{0.0f, 1e9f};
  EXPECT_THROW(deskew(cloud, few, at_stamp_from_at), Error);
  EXPECT_THROW(deskew(cloud, broken, at_stamp_from_at), Error);
  EXPECT_THROW(deskew(cloud, wide, at_stamp_from_at), Error);
}

}  // namespace
}  // namespace remount::cloud
