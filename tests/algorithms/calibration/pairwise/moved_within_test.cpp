#include "algorithms/calibration/pairwise/moved_within.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "algorithms/messages/render.h"
#include "tests/algorithms/support/simulated_drive.h"

namespace remount::calibration {
namespace {

struct Moved {
  CalibrationResult result;
  double last_s = 0.0, told_s = 0.0;  ///< when the drive ends, and when it is said to have moved; 0: not at all
};

/// Of a drive on which the LiDAR turns about its z when this share of the time is over. @param turned_rad then
Moved solve_moved(double share, double turned_rad, int seed, double outliers = 0.0) {
  testing::DriveOptions options;
  testing::SimulatedDrive drive = testing::simulate(options, seed);
  std::vector<motion::Pair> pairs = testing::pairs_of(drive);
  const std::vector<JointNode>& nodes = drive.problem.nodes;
  Moved out;
  out.last_s = nodes.back().time_s;
  const RigidTransform turn = make_rigid(so3_exp(Eigen::Vector3d(0.0, 0.0, turned_rad)), Eigen::Vector3d::Zero());
  const auto turn_at = [&](motion::KeyframeIndex node) {
    return nodes[node].time_s > share * out.last_s ? turn : RigidTransform::Identity();
  };
  std::size_t bad = 0;
  for (motion::Pair& pair : pairs) {
    pair.lidar_b_from_lidar_a =
        turn_at(pair.keyframe_b).inverse() * pair.lidar_b_from_lidar_a * turn_at(pair.keyframe_a);
    if (nodes[pair.keyframe_a].time_s > share * out.last_s && outliers > 0.0)  // each in another way
      pair.lidar_b_from_lidar_a.translate(outliers * Eigen::Vector3d(bad % 3 - 1.0, bad % 5 - 2.0, 0.0)), ++bad;
  }
  const PairwiseInput input = testing::input_of(drive, options);
  out.result = solve_pairwise(input, pairs, {});
  std::vector<motion::PairIndex> usable;
  for (motion::PairIndex i; i < pairs.size(); ++i) usable.push_back(i);
  for (const MovedWithin& moved : find_moved_within(input, pairs, usable, out.result.noise, {}))
    out.told_s = moved.time_s;
  return out;
}

bool advises_parts_apart(const CalibrationResult& result) {
  return std::ranges::any_of(result.advice, [](const Message& advice) {
    return english(advice).find("has two mountings") != std::string::npos;
  });
}

TEST(moved_within, a_lidar_that_turns_on_the_way_has_no_one_mounting) {
  for (const double share : {0.35, 0.5, 0.7}) {
    const Moved moved = solve_moved(share, 0.1, 4);
    std::printf("turned at %.1f s: %s\n", share * moved.last_s, english(moved.result.message).c_str());
    EXPECT_EQ(moved.result.status, Status::Inconsistent) << share;
    EXPECT_NEAR(moved.told_s, share * moved.last_s, 1.5);
    EXPECT_TRUE(moved.result.observed().empty());
    EXPECT_TRUE(advises_parts_apart(moved.result)) << share;
  }
}

TEST(moved_within, a_drive_with_one_mounting_has_none_of_it) {
  for (int seed = 1; seed <= 5; ++seed) {
    const CalibrationResult result = solve_moved(0.5, 0.0, seed).result;
    EXPECT_EQ(result.status, Status::Ok) << english(result.message);
    EXPECT_FALSE(advises_parts_apart(result));
  }
}

// Pairs that fail each in another way agree on no mounting.
TEST(moved_within, a_part_whose_registrations_fail_is_no_other_mounting) {
  const CalibrationResult result = solve_moved(0.7, 0.0, 4, 0.7).result;
  EXPECT_EQ(result.status, Status::Ok) << english(result.message);
  EXPECT_FALSE(advises_parts_apart(result));
  EXPECT_GT(result.pairs_rejected, 12);
}

}  // namespace
}  // namespace remount::calibration
