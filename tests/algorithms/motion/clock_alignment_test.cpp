#include "algorithms/motion/clock_alignment.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "algorithms/messages/render.h"

namespace remount::motion {
namespace {

/// Attitude of a vehicle that turns in no regular way.
Eigen::Matrix3d attitude_at(double t) {
  return rotation_from_yaw_pitch_roll(
      {1.5 * std::sin(0.31 * t) + 0.8 * std::sin(0.83 * t + 1.0) + 0.1 * std::sin(2.3 * t), 0.05 * std::sin(0.7 * t),
       0.04 * std::cos(0.9 * t)});
}

std::vector<StampedPose> stream(double from_s, double to_s, double rate_hz, double clock_s, double noise_rad,
                                const Eigen::Matrix3d& mounting) {
  std::mt19937 random(11);
  std::normal_distribution<double> noise(0.0, noise_rad);
  std::vector<StampedPose> poses;
  for (int i = 0; from_s + i / rate_hz < to_s; ++i) {
    const double t = from_s + i / rate_hz;
    StampedPose pose;
    pose.stamp_ns = std::llround((t + clock_s) * 1e9) + 1'600'000'000'000'000'000;
    pose.pose.linear() = attitude_at(t) * mounting * so3_exp({noise(random), noise(random), noise(random)});
    poses.push_back(pose);
  }
  return poses;
}

const Eigen::Matrix3d kMounting = rotation_from_yaw_pitch_roll({-1.58, 0.2, 0.1});

TEST(clock_alignment, finds_an_offset_below_a_sample_whatever_the_mounting) {
  for (const double clock_s : {0.0, 0.0371, -214.3, 5000.123}) {
    const ClockAlignment result =
        align_clocks(stream(0, 60, 50, 0, 0, Eigen::Matrix3d::Identity()), stream(10, 55, 10, clock_s, 0, kMounting));
    ASSERT_TRUE(result.found) << result.why;
    EXPECT_FALSE(result.ambiguous) << result.why << " " << result.correlation << " " << result.runner_up;
    EXPECT_NEAR(result.offset_s, -clock_s, 0.003) << "sigma " << result.sigma_s;
  }
}

TEST(clock_alignment, noise_is_within_its_sigma) {
  const ClockAlignment result = align_clocks(stream(0, 80, 100, 0, 0.0005, Eigen::Matrix3d::Identity()),
                                             stream(5, 70, 10, 3.21, 0.004, kMounting));
  ASSERT_TRUE(result.found && !result.ambiguous) << result.why;
  EXPECT_LT(std::abs(result.offset_s + 3.21), 3.5 * result.sigma_s) << result.offset_s << " sigma " << result.sigma_s;
  EXPECT_LT(result.sigma_s, 0.05);
}

TEST(clock_alignment, gaps_do_not_matter) {
  std::vector<StampedPose> reference = stream(0, 60, 50, 0, 0, Eigen::Matrix3d::Identity());
  reference.erase(reference.begin() + 1000, reference.begin() + 1200);
  const ClockAlignment result = align_clocks(reference, stream(2, 58, 10, 1.0, 0, kMounting));
  EXPECT_NEAR(result.offset_s, -1.0, 0.003) << result.why;
}

TEST(clock_alignment, offsets_beyond_the_limit_are_neither_answers_nor_rivals) {
  // A road that winds evenly: every half period looks the same.
  const auto winding = [](double clock_s) {
    std::vector<StampedPose> poses;
    for (int i = 0; i < 600; ++i)
      poses.push_back({std::llround((0.1 * i + clock_s) * 1e9) + 1'600'000'000'000'000'000,
                       make_rigid(rotation_from_yaw_pitch_roll({std::sin(0.4 * 0.1 * i), 0, 0}), {0, 0, 0})});
    return poses;
  };
  ClockAlignmentOptions near;
  near.max_offset_s = 3.0;
  EXPECT_TRUE(align_clocks(winding(0.0), winding(0.5)).ambiguous);
  const ClockAlignment result = align_clocks(winding(0.0), winding(0.5), near);
  ASSERT_TRUE(result.found) << result.why;
  EXPECT_FALSE(result.ambiguous) << result.why << " " << result.correlation << " " << result.runner_up;
  EXPECT_NEAR(result.offset_s, -0.5, 0.003);
  near.max_offset_s = 1.0;
  EXPECT_FALSE(align_clocks(winding(0.0), winding(5000.0), near).found) << "no offset within the limit overlaps";
}

TEST(clock_alignment, says_where_there_is_no_answer) {
  std::vector<StampedPose> straight = stream(0, 60, 10, 0, 0, kMounting);
  for (StampedPose& pose : straight) pose.pose = RigidTransform::Identity();
  EXPECT_FALSE(align_clocks(stream(0, 60, 50, 0, 0, kMounting), straight).found);
  EXPECT_FALSE(align_clocks({}, straight).found);
  EXPECT_FALSE(align_clocks(stream(0, 3, 50, 0, 0, kMounting), stream(0, 3, 10, 0, 0, kMounting)).found);
  // A vehicle that swings evenly fits itself a period later.
  std::vector<StampedPose> even = stream(0, 60, 20, 0, 0, kMounting);
  for (std::size_t i = 0; i < even.size(); ++i)
    even[i].pose.linear() = rotation_from_yaw_pitch_roll({std::sin(0.1 * static_cast<double>(i)), 0, 0});
  const ClockAlignment periodic = align_clocks(even, even);
  EXPECT_TRUE(periodic.ambiguous) << periodic.correlation << " next " << periodic.runner_up;
  // Another drive altogether.
  std::vector<StampedPose> other = stream(100, 160, 20, 0, 0, kMounting);
  for (std::size_t i = 0; i < other.size(); ++i)
    other[i].pose.linear() = rotation_from_yaw_pitch_roll({std::sin(0.0004 * static_cast<double>(i * i % 3001)), 0, 0});
  EXPECT_TRUE(align_clocks(stream(0, 60, 50, 0, 0, kMounting), other).ambiguous);
}

}  // namespace
}  // namespace remount::motion
