#include "algorithms/odometry/fusion/ackermann.h"

#include <gtest/gtest.h>

#include <cmath>

#include "algorithms/odometry/fusion/fusion_step_parts.h"

namespace remount::odometry {
namespace {

constexpr std::int64_t kStart_ns = 1700000000000000000;

std::int64_t at(double time_s) { return kStart_ns + std::llround(time_s * 1e9); }

// A constant speed and angular rate, 100 Hz and 50 Hz.
DeadReckoning circling(double speed_mps, const Eigen::Vector3d& rate_radps, const RigidTransform& vehicle_from_imu,
                       double track_width_m = 1.6) {
  std::vector<motion::ImuSample> imu;
  std::vector<motion::WheelSample> wheels;
  for (int i = 0; i <= 1000; ++i)
    imu.push_back({at(0.01 * i), vehicle_from_imu.linear().transpose() * rate_radps, {0.0, 0.0, 9.81}});
  for (int i = 0; i <= 500; ++i)
    wheels.push_back({at(0.02 * i), speed_mps - 0.5 * track_width_m * rate_radps.z(),
                      speed_mps + 0.5 * track_width_m * rate_radps.z()});
  return {imu, wheels, vehicle_from_imu, track_width_m};
}

RigidTransform circle(double speed_mps, const Eigen::Vector3d& rate_radps, double time_s) {
  const Eigen::Vector3d turn = rate_radps * time_s;
  return make_rigid(so3_exp(turn), so3_left_jacobian(turn).col(0) * speed_mps * time_s);
}

TEST(dead_reckoning, a_steady_turn_ends_where_the_exponential_says) {
  const Eigen::Vector3d rate(0.02, -0.03, 0.4);
  const RigidTransform vehicle_from_imu = make_rigid(so3_exp({0.1, -0.2, 0.7}), {0.5, 0.2, 0.3});
  const DeadReckoning reckoning = circling(8.0, rate, vehicle_from_imu);
  const auto path = reckoning.path(at(1.0), at(7.0), at(1.0), {});
  ASSERT_TRUE(path);
  const RigidTransform expected = circle(8.0, rate, 6.0);
  EXPECT_LT((path->start_from_vehicle.back().translation() - expected.translation()).norm(), 1e-6);
  EXPECT_LT(rotation_angle_between_rad(path->start_from_vehicle.back(), expected), 1e-9);
  EXPECT_NEAR(path->mean_speed_mps, 8.0, 1e-9);
  EXPECT_LT((path->at(2.5).translation() - circle(8.0, rate, 2.5).translation()).norm(), 1e-4);
}

TEST(dead_reckoning, bias_is_taken_off_and_scale_multiplied) {
  const Eigen::Vector3d rate(0.0, 0.0, 0.3), bias(0.01, 0.02, -0.05);
  const DeadReckoning reckoning = circling(5.0, rate + bias, RigidTransform::Identity());
  const auto path = reckoning.path(at(0.0), at(4.0), at(0.0), {bias, 1.02});
  ASSERT_TRUE(path);
  EXPECT_LT((path->start_from_vehicle.back().translation() - circle(5.1, rate, 4.0).translation()).norm(), 1e-6);
}

TEST(dead_reckoning, without_a_gyroscope_the_wheels_tell_the_turn) {
  const Eigen::Vector3d rate(0.0, 0.0, 0.3);
  std::vector<motion::WheelSample> wheels;
  for (int i = 0; i <= 500; ++i) wheels.push_back({at(0.02 * i), 5.0 - 0.24, 5.0 + 0.24});
  const DeadReckoning reckoning({}, wheels, RigidTransform::Identity(), 1.6);
  const auto path = reckoning.path(at(0.0), at(4.0), at(0.0), {});
  ASSERT_TRUE(path);
  EXPECT_TRUE(path->has_rotation);
  EXPECT_LT((path->start_from_vehicle.back().translation() - circle(5.0, rate, 4.0).translation()).norm(), 1e-6);
}

TEST(dead_reckoning, where_the_gyroscope_is_silent_the_wheels_tell_the_turn) {
  const Eigen::Vector3d rate(0.0, 0.0, 0.3), bias(0.0, 0.0, 0.02);
  std::vector<motion::ImuSample> imu;
  std::vector<motion::WheelSample> wheels;
  for (int i = 0; i <= 400; ++i)
    if (i < 100 || i > 300) imu.push_back({at(0.01 * i), rate + bias, Eigen::Vector3d::Zero()});
  for (int i = 0; i <= 200; ++i) wheels.push_back({at(0.02 * i), 5.0 - 0.24, 5.0 + 0.24});
  const DeadReckoning reckoning(imu, wheels, RigidTransform::Identity(), 1.6);
  const auto across = reckoning.path(at(0.5), at(3.5), at(0.5), {bias, 1.0});
  ASSERT_TRUE(across);
  EXPECT_TRUE(across->has_rotation && across->has_speed);
  EXPECT_FALSE(across->by_gyro);
  EXPECT_LT((across->start_from_vehicle.back().translation() - circle(5.0, rate, 3.0).translation()).norm(), 1e-6);
  const auto before = reckoning.path(at(0.1), at(0.5), at(0.1), {bias, 1.0});
  ASSERT_TRUE(before);
  EXPECT_TRUE(before->by_gyro);
  // Worth what wheels are worth there, not what the gyroscope is.
  EXPECT_GT(motion_sigma({}, across, true, 0.1, 0.0).turn_rad.z(),
            10.0 * motion_sigma({}, before, true, 0.1, 0.0).turn_rad.z());
}

TEST(dead_reckoning, says_nothing_across_a_gap_or_outside_the_data) {
  const DeadReckoning reckoning = circling(5.0, {0.0, 0.0, 0.1}, RigidTransform::Identity());
  EXPECT_FALSE(reckoning.path(at(9.5), at(11.0), at(9.5), {}));
  EXPECT_FALSE(reckoning.path(at(-1.0), at(1.0), at(0.0), {}));
  EXPECT_TRUE(reckoning.path(at(-0.05), at(1.0), at(0.0), {}));
  EXPECT_FALSE(reckoning.path(at(2.0), at(1.0), at(0.0), {}));
  EXPECT_FALSE(DeadReckoning({}, {}, RigidTransform::Identity(), 1.6).path(at(0.0), at(1.0), at(0.0), {}));
}

TEST(dead_reckoning, at_rest_the_gyroscope_reads_its_bias) {
  const Eigen::Vector3d bias(0.001, -0.002, 0.003);
  const DeadReckoning standing({{at(0.0), bias, {}}, {at(0.01), bias, {}}, {at(0.02), bias, {}}, {at(0.03), bias, {}}},
                               {{at(0.0), 0.01, -0.01}, {at(0.01), -0.02, 0.02}, {at(0.02), 0.0, 0.0}},
                               RigidTransform::Identity(), 1.6);
  const auto rate = standing.standstill_rate_radps(at(0.0), at(0.05));
  ASSERT_TRUE(rate);
  EXPECT_LT((*rate - bias).norm(), 1e-12);
  EXPECT_FALSE(circling(0.5, bias, RigidTransform::Identity()).standstill_rate_radps(at(1.0), at(1.1)));
}

}  // namespace
}  // namespace remount::odometry
