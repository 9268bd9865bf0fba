#include "algorithms/motion/pairing.h"

#include <gtest/gtest.h>

namespace remount::motion {
namespace {

struct PairedDrive {
  std::vector<Keyframe> keyframes;
  std::vector<RigidTransform> poses;
};

// Keyframes `step_m` and `step_s` apart, straight on.
PairedDrive straight(int count, double step_m, double step_s, SessionIndex session = {}) {
  PairedDrive drive;
  for (int i = 0; i < count; ++i) {
    drive.keyframes.push_back(
        {session, index_at<ScanIndex>(i), static_cast<std::int64_t>(i * step_s * 1e9), i * step_m});
    drive.poses.push_back(make_rigid(Eigen::Matrix3d::Identity(), {i * step_m, 0, 0}));
  }
  return drive;
}

PairingOptions generous() {
  PairingOptions options;
  options.max_partners = 100;
  return options;
}

TEST(pairing, the_motion_of_a_pair_is_that_of_its_two_poses) {
  PairedDrive drive = straight(2, 1.0, 0.5);
  drive.poses[0] = make_rigid(so3_exp({0.1, 0.2, 0.3}), {1, 2, 3});
  drive.poses[1] = make_rigid(so3_exp({0.1, 0.2, 0.5}), {2, 2, 3});
  const std::vector<Pair> pairs = propose_pairs(drive.keyframes, drive.poses, generous());
  ASSERT_EQ(pairs.size(), 1U);
  EXPECT_TRUE((drive.poses[1] * pairs[0].ins_b_from_ins_a).isApprox(drive.poses[0], 1e-12));
  EXPECT_EQ(pairs[0].keyframe_a, KeyframeIndex{0});
  EXPECT_EQ(pairs[0].keyframe_b, KeyframeIndex{1});
  EXPECT_NEAR(pairs[0].gap_s, 0.5, 1e-9);
  EXPECT_NEAR(pairs[0].baseline_m, 1.0, 1e-12);
  EXPECT_NEAR(pairs[0].rotation_rad, so3_log(pairs[0].ins_b_from_ins_a.linear()).norm(), 1e-12);
  EXPECT_EQ(pairs[0].state, PairState::Proposed);
}

TEST(pairing, each_limit_is_kept_and_either_is_the_union) {
  const PairedDrive fast = straight(60, 2.0, 0.1), slow = straight(60, 0.5, 0.4);
  PairingOptions options = generous();
  options.max_gap_s = 1.0;
  options.max_distance_m = 6.0;
  for (const PairedDrive* drive : {&fast, &slow}) {
    std::size_t counts[3] = {};
    for (const PairLimit limit : {PairLimit::Time, PairLimit::Distance, PairLimit::Either}) {
      options.limit = limit;
      const std::vector<Pair> pairs = propose_pairs(drive->keyframes, drive->poses, options);
      counts[static_cast<int>(limit)] = pairs.size();
      for (const Pair& pair : pairs) {
        EXPECT_TRUE(limit != PairLimit::Time || pair.gap_s <= 1.0) << pair.gap_s;
        EXPECT_TRUE(limit != PairLimit::Distance || pair.baseline_m <= 6.0) << pair.baseline_m;
        EXPECT_TRUE(pair.gap_s <= 1.0 || pair.baseline_m <= 6.0);
      }
    }
    EXPECT_GT(counts[0], 0U);
    EXPECT_GT(counts[1], 0U);
    EXPECT_EQ(counts[2], std::max(counts[0], counts[1])) << "one limit contains the other on a steady drive";
  }
}

TEST(pairing, a_pair_must_have_moved_or_turned) {
  PairedDrive still = straight(10, 0.01, 0.1);
  EXPECT_TRUE(propose_pairs(still.keyframes, still.poses, generous()).empty());
  for (std::size_t i = 0; i < still.poses.size(); ++i)
    still.poses[i].linear() = so3_exp({0, 0, degrees_to_radians(1.01 * static_cast<double>(i))});
  EXPECT_EQ(propose_pairs(still.keyframes, still.poses, generous()).size(), 45U) << "turning on the spot counts";
}

TEST(pairing, partners_are_taken_among_those_that_may_share_something) {
  const PairedDrive drive = straight(30, 1.0, 10.0);
  PairingOptions options = generous();
  options.max_partners = 3;
  const auto near = [](const Pair& pair) { return pair.baseline_m < 4.5; };
  const std::vector<Pair> pairs = propose_pairs(drive.keyframes, drive.poses, options, near);
  std::size_t of_first = 0;
  for (const Pair& pair : pairs) {
    EXPECT_TRUE(near(pair)) << pair.baseline_m;
    of_first += pair.keyframe_a == KeyframeIndex{0};
  }
  EXPECT_EQ(of_first, 3U) << "as many as without the condition";
}

TEST(pairing, partners_are_limited_and_spread_over_short_and_long_gaps) {
  const PairedDrive drive = straight(30, 0.5, 10.0);
  PairingOptions options;
  options.max_partners = 4;
  const std::vector<Pair> pairs = propose_pairs(drive.keyframes, drive.poses, options);
  std::vector<std::size_t> partners_of_first;
  std::vector<int> counts(30, 0);
  for (const Pair& pair : pairs) {
    ++counts[pair.keyframe_a];
    EXPECT_LT(pair.keyframe_a, pair.keyframe_b);
    if (pair.keyframe_a == KeyframeIndex{0}) partners_of_first.push_back(pair.keyframe_b);
  }
  for (const int count : counts) EXPECT_LE(count, 4);
  EXPECT_EQ(partners_of_first, (std::vector<std::size_t>{1, 7, 13, 20}));
  options.max_partners = 1;
  EXPECT_EQ(propose_pairs(drive.keyframes, drive.poses, options).front().keyframe_b, KeyframeIndex{1});
}

TEST(pairing, sessions_are_never_mixed) {
  PairedDrive drive = straight(10, 1.0, 0.1, SessionIndex{0});
  const PairedDrive second = straight(10, 1.0, 0.1, SessionIndex{1});
  drive.keyframes.insert(drive.keyframes.end(), second.keyframes.begin(), second.keyframes.end());
  drive.poses.insert(drive.poses.end(), second.poses.begin(), second.poses.end());
  const std::vector<Pair> pairs = propose_pairs(drive.keyframes, drive.poses, generous());
  EXPECT_EQ(pairs.size(), 90U);
  for (const Pair& pair : pairs) EXPECT_EQ(pair.keyframe_a / 10, pair.keyframe_b / 10);
}

}  // namespace
}  // namespace remount::motion
