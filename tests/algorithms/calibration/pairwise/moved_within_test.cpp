#include "algorithms/calibration/pairwise/moved_within.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "algorithms/messages/render.h"
#include "tests/algorithms/support/simulated_drive.h"

namespace remount::calibration {
namespace {

struct Drive {
  PairwiseInput input;
  std::vector<motion::Pair> pairs;

  double last_s() const {
    double last_s = 0.0;
    for (const JointNode& node : input.nodes) last_s = std::max(last_s, node.time_s);
    return last_s;
  }
  CalibrationResult solve() {
    CalibrationResult result = solve_pairwise(input, pairs, {});
    report_moved_within(input, pairs, {}, result);
    return result;
  }
};

Drive drive_of(int seed, int sessions = 1) {
  testing::DriveOptions options;
  options.sessions = sessions;
  const testing::SimulatedDrive drive = testing::simulate(options, seed);
  return {testing::input_of(drive, options), testing::pairs_of(drive)};
}

/// The LiDAR turns about its z when this share of the time of the first session is over.
Drive moved_drive(double share, double turned_rad, int seed, int sessions = 1) {
  Drive drive = drive_of(seed, sessions);
  const RigidTransform turn = make_rigid(so3_exp(Eigen::Vector3d(0.0, 0.0, turned_rad)), Eigen::Vector3d::Zero());
  const double last_s = drive.last_s();
  const auto turn_at = [&](motion::KeyframeIndex keyframe) {
    const JointNode& node = drive.input.nodes[keyframe];
    return node.session == motion::SessionIndex{0} && node.time_s > share * last_s ? turn : RigidTransform::Identity();
  };
  for (motion::Pair& pair : drive.pairs)
    pair.lidar_b_from_lidar_a =
        turn_at(pair.keyframe_b).inverse() * pair.lidar_b_from_lidar_a * turn_at(pair.keyframe_a);
  return drive;
}

bool advises_parts_apart(const CalibrationResult& result) {
  return std::ranges::any_of(result.advice, [](const Message& advice) {
    return english(advice).find("has two mountings") != std::string::npos;
  });
}

TEST(moved_within, a_lidar_that_turns_on_the_way_has_no_one_mounting) {
  for (const double share : {0.35, 0.5, 0.7}) {
    Drive drive = moved_drive(share, 0.1, 4);
    CalibrationResult alone = solve_pairwise(drive.input, drive.pairs, {});
    const std::vector<MovedWithin> moved =
        find_moved_within(drive.input, drive.pairs, alone.mounting.ins_from_lidar(), {});
    ASSERT_EQ(moved.size(), 1u) << share;
    std::printf("turned at %.1f s, found at %.1f s\n", share * drive.last_s(), moved[0].time_s);
    EXPECT_NEAR(moved[0].time_s, share * drive.last_s(), 1.5);
    report_moved_within(drive.input, drive.pairs, {}, alone);
    EXPECT_EQ(alone.status, Status::Inconsistent) << english(alone.message);
    EXPECT_TRUE(alone.observed().empty());
    EXPECT_TRUE(advises_parts_apart(alone)) << share;
  }
}

TEST(moved_within, another_session_says_which_of_the_two_is_meant) {
  Drive drive = moved_drive(0.5, 0.1, 4, 3);
  const CalibrationResult result = drive.solve();
  EXPECT_TRUE(is_solved(result.status)) << english(result.message);
  EXPECT_TRUE(advises_parts_apart(result));
  EXPECT_LT(rotation_angle_between_rad(result.mounting.ins_from_lidar(), testing::mounting()), 2e-3);
}

TEST(moved_within, a_drive_with_one_mounting_has_none_of_it) {
  for (int seed = 1; seed <= 5; ++seed) {
    const CalibrationResult result = drive_of(seed).solve();
    EXPECT_EQ(result.status, Status::Ok) << english(result.message);
    EXPECT_FALSE(advises_parts_apart(result));
  }
}

/// What is behind 0.7 of the drive is rejected.
std::size_t reject_end(Drive& drive) {
  std::size_t rejected = 0;
  const double from_s = 0.7 * drive.last_s();
  for (motion::Pair& pair : drive.pairs)
    if (std::min(drive.input.nodes[pair.keyframe_a].time_s, drive.input.nodes[pair.keyframe_b].time_s) > from_s) {
      pair.state = motion::PairState::Rejected;
      ++rejected;
    }
  return rejected;
}

// As a tunnel has it, in which scans slide and fit X all the same.
TEST(moved_within, pairs_that_are_rejected_for_another_reason_are_no_other_mounting) {
  Drive drive = drive_of(4);
  const CalibrationResult result = solve_pairwise(drive.input, drive.pairs, {});
  EXPECT_GT(reject_end(drive), 12u);
  EXPECT_TRUE(find_moved_within(drive.input, drive.pairs, result.mounting.ins_from_lidar(), {}).empty());
}

// An INS that is bad for a while, or registrations that fail, each in another way.
TEST(moved_within, pairs_that_fail_each_in_another_way_are_no_other_mounting) {
  for (const double off_m : {0.1, 0.3, 0.7}) {
    Drive drive = drive_of(4);
    const double from_s = 0.7 * drive.last_s();
    std::size_t bad = 0;
    for (motion::Pair& pair : drive.pairs)
      if (drive.input.nodes[pair.keyframe_a].time_s > from_s) {
        pair.lidar_b_from_lidar_a.translate(
            off_m * Eigen::Vector3d(static_cast<double>(bad % 3) - 1.0, static_cast<double>(bad % 5) - 2.0, 0.0));
        ++bad;
      }
    const CalibrationResult result = solve_pairwise(drive.input, drive.pairs, {});
    const std::size_t rejected = reject_end(drive);
    std::printf("off by %.1f m: %zu pairs rejected\n", off_m, rejected);
    EXPECT_TRUE(find_moved_within(drive.input, drive.pairs, result.mounting.ins_from_lidar(), {}).empty()) << off_m;
  }
}

}  // namespace
}  // namespace remount::calibration
