#include "algorithms/odometry/lidar/sweep_motion.h"

#include <gtest/gtest.h>

#include <array>

namespace remount::odometry {
namespace {

// A LiDAR beside the axis of a turn that begins: its rate and its speed grow evenly.
RigidTransform accelerated(double time_s) {
  const SweepMotion motion{(Vector6d() << 6.0, -0.4, 0.1, 0.02, -0.03, 0.5).finished(),
                           (Vector6d() << 0.8, 0.3, -0.1, 0.1, 0.05, 0.4).finished()};
  return motion.at(time_s);
}

double off_m(const RigidTransform& a, const RigidTransform& b) { return difference(a, b).norm(); }

TEST(sweep_motion, follows_what_speed_and_rate_change_by_from_the_poses_before_and_after) {
  for (const auto& [before_s, after_s] : {std::pair{-0.1, 0.1}, std::pair{-0.1, 0.3}, std::pair{-0.4, -0.2}}) {
    const SweepMotion motion = SweepMotion::through(
        std::array{TimedMotion{before_s, accelerated(before_s)}, TimedMotion{after_s, accelerated(after_s)}});
    for (const double time_s : {-0.1, -0.05, 0.0, 0.02, 0.1})
      EXPECT_LT(off_m(motion.at(time_s), accelerated(time_s)), 1e-12) << time_s;
  }
}

TEST(sweep_motion, is_a_constant_velocity_through_one_other_pose_and_rest_through_none) {
  const SweepMotion one = SweepMotion::through(std::array{TimedMotion{-0.1, accelerated(-0.1)}});
  EXPECT_LT(off_m(one.at(-0.1), accelerated(-0.1)), 1e-12);
  EXPECT_LT(off_m(one.at(0.1) * one.at(-0.1), RigidTransform::Identity()), 1e-12);
  EXPECT_LT(off_m(SweepMotion::through({}).at(0.05), RigidTransform::Identity()), 1e-15);
}

}  // namespace
}  // namespace remount::odometry
