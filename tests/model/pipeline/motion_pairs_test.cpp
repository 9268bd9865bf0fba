// Solving from motions that were computed elsewhere.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>

#include "algorithms/core/error.h"
#include "algorithms/messages/render.h"
#include "model/formats/poses/motion_pairs_file.h"
#include "tests/support/calibration_checks.h"

namespace remount::pipeline {
namespace {

const std::filesystem::path kPairs = std::filesystem::path(REMOUNT_SOURCE_DIR) / "../shared/data/pairs";

calibration::CalibrationResult solve(formats::MotionPairs motions, const std::string& only_set = "",
                                     const std::optional<RigidTransform>& nominal = {}) {
  std::erase_if(motions.pairs, [&](const motion::Pair& pair) {
    const motion::SessionIndex set = motions.keyframes[pair.keyframe_a].session;
    return !only_set.empty() && motions.sets[set] != only_set;
  });
  Progress progress;
  return solve_motion_pairs(motions.keyframes, motions.pairs, {}, nominal, progress);
}

TEST(motion_pairs_solution, exact_pairs_give_x_to_the_digits_of_the_file) {
  if (!std::filesystem::exists(kPairs)) GTEST_SKIP() << kPairs << " is not there";
  Eigen::Matrix3d rotation;
  rotation << 0.000534078, -0.999853228, 0.017124172, 0.999955744, 0.000373132, -0.009400599, 0.009392830, 0.017128435,
      0.999809178;
  const RigidTransform truth = make_rigid(nearest_rotation(rotation), {0.002460668, 1.194937238, 1.388801166});
  const calibration::CalibrationResult result = solve(formats::read_motion_pairs(kPairs / "opencalib_PQ_exact.csv"));
  EXPECT_LE(rotation_angle_between_rad(result.mounting.reference_from_sensor, truth), 1e-6);
  EXPECT_LE((result.mounting.reference_from_sensor.translation() - truth.translation()).norm(), 1e-5);
  EXPECT_EQ(result.status, calibration::Status::Ok) << english(result.message);
  testing::expect_within_sigma(result, truth, 3.5);
}

TEST(motion_pairs_solution, recorded_pairs_that_share_scans_are_within_the_sigma) {
  if (!std::filesystem::exists(kPairs)) GTEST_SKIP() << kPairs << " is not there";
  Eigen::Matrix3d rotation;
  rotation << 0.999997642, -0.000785403, 0.002024406, 0.000755307, 0.999889825, 0.014824542, -0.002035826, -0.014822978,
      0.999888061;
  const RigidTransform kitti = make_rigid(nearest_rotation(rotation), {0.810543938, -0.307054366, 0.802724026});
  const calibration::CalibrationResult result = solve(formats::read_motion_pairs(kPairs / "kitti_PQ_icp_vs_ins.csv"));
  testing::error_of(result, kitti);
  testing::expect_within_sigma(result, kitti, 3.5);
  for (const calibration::ObservabilityDirection& direction : result.directions)
    if (std::abs(direction.direction[2]) > 0.9) {
      EXPECT_EQ(direction.observed, result.known[calibration::Parameter::Z].observed) << direction.words;
    }
}

// Ten scans each, over which the INS drifts as far as the vehicle turns.
TEST(motion_pairs_solution, short_recorded_drives_claim_no_more_than_they_show) {
  if (!std::filesystem::exists(kPairs)) GTEST_SKIP() << kPairs << " is not there";
  const RigidTransform kitti = rigid_from_six(
      {0.8105, -0.3071, 0.8027, degrees_to_radians(0.0433), degrees_to_radians(0.1166), degrees_to_radians(-0.8493)});
  const formats::MotionPairs motions = formats::read_motion_pairs(kPairs / "kitti_PQ_icp_vs_ins.csv");
  for (const char* set : {"00", "05", "07", "10"}) {
    const calibration::CalibrationResult result = solve(motions, set, rigid_from_six({0.8, -0.3, 0.8, 0.0, 0.0, 0.0}));
    std::printf("  %s: ", set);
    testing::error_of(result, kitti);
    if (calibration::is_usable(result)) testing::expect_within_sigma(result, kitti, 3.5);
  }
}

TEST(motion_pairs_solution, sets_that_contradict_each_other_leave_the_reference_within_the_sigma) {
  if (!std::filesystem::exists(kPairs)) GTEST_SKIP() << kPairs << " is not there";
  const formats::MotionPairs motions = formats::read_motion_pairs(kPairs / "zxl19_PQ_inspvax_vs_aloam.csv");
  const RigidTransform reference = make_rigid((Eigen::AngleAxisd(degrees_to_radians(0.134), Eigen::Vector3d::UnitX()) *
                                               Eigen::AngleAxisd(degrees_to_radians(0.619), Eigen::Vector3d::UnitY()) *
                                               Eigen::AngleAxisd(degrees_to_radians(-90.443), Eigen::Vector3d::UnitZ()))
                                                  .toRotationMatrix(),
                                              {-0.004, 0.379, 0.13});
  const calibration::CalibrationResult together = solve(motions);
  testing::error_of(together, reference);
  std::printf("  sets scatter %.2f times as much as their errors explain\n", together.session_disagreement);
  EXPECT_GT(together.session_disagreement, 2.0) << "the drives' own answers differ by half a degree of yaw";
  testing::expect_within_sigma(together, reference, 3.5);
}

// Exact motions of a winding drive, each pair's keyframes by number.
formats::MotionPairs winding() {
  formats::MotionPairs motions;
  motions.sets = {"drive"};
  const RigidTransform x = rigid_from_six({1.0, 0.2, 1.5, 0.3, 0.05, -0.04});
  std::vector<RigidTransform> poses;
  for (int k = 0; k < 20; ++k) {
    poses.push_back(rigid_from_six(
        {1.5 * k, std::sin(0.5 * k), 0.0, 0.5 * std::sin(0.4 * k), 0.1 * std::sin(0.9 * k), 0.1 * std::cos(0.7 * k)}));
    motions.keyframes.push_back({motion::SessionIndex{0}, index_at<motion::ScanIndex>(k), k, 0.0});
  }
  for (int a = 0; a < 20; ++a)
    for (int b = a + 1; b < std::min(20, a + 4); ++b) {
      motion::Pair pair;
      pair.keyframe_a = index_at<motion::KeyframeIndex>(b);
      pair.keyframe_b = index_at<motion::KeyframeIndex>(a);
      pair.ins_b_from_ins_a = poses[static_cast<std::size_t>(a)].inverse() * poses[static_cast<std::size_t>(b)];
      pair.lidar_b_from_lidar_a = x.inverse() * pair.ins_b_from_ins_a * x;
      motions.pairs.push_back(pair);
    }
  return motions;
}

TEST(motion_pairs_solution, pairs_keep_their_keyframes_whether_these_name_poses_or_not) {
  const RigidTransform truth = rigid_from_six({1.0, 0.2, 1.5, 0.3, 0.05, -0.04});
  for (const bool poses_shared : {true, false}) {
    formats::MotionPairs motions = winding();
    if (!poses_shared)
      for (motion::Pair& pair : motions.pairs) pair.keyframe_a = pair.keyframe_b;  // numbers of rows
    const std::vector<motion::Pair> before = motions.pairs;
    Progress progress;
    const calibration::CalibrationResult result =
        solve_motion_pairs(motions.keyframes, motions.pairs, {}, {}, progress);
    EXPECT_EQ(result.status, calibration::Status::Ok) << english(result.message);
    EXPECT_LT((result.mounting.reference_from_sensor.translation() - truth.translation()).norm(), 1e-6);
    for (std::size_t i = 0; i < before.size(); ++i) {
      EXPECT_EQ(motions.pairs[i].keyframe_a, before[i].keyframe_a);
      EXPECT_EQ(motions.pairs[i].keyframe_b, before[i].keyframe_b);
    }
  }
}

/// Thirty copies of a list are no thirty lists: sigma would be a fifth of what it is. Nor do they make those that are
/// used so few that they might agree by chance.
TEST(motion_pairs_solution, rows_that_repeat_others_do_not_count_and_are_named) {
  formats::MotionPairs once = winding();
  for (std::size_t i = 0; i < once.pairs.size(); ++i)  // noise, for a sigma
    once.pairs[i].lidar_b_from_lidar_a.translation().x() += 0.01 * std::sin(37.0 * static_cast<double>(i));
  formats::MotionPairs often = once;
  for (int copy = 1; copy < 30; ++copy) often.pairs.insert(often.pairs.end(), once.pairs.begin(), once.pairs.end());
  Progress progress;
  const calibration::CalibrationResult single = solve_motion_pairs(once.keyframes, once.pairs, {}, {}, progress);
  const calibration::CalibrationResult repeated = solve_motion_pairs(often.keyframes, often.pairs, {}, {}, progress);
  std::printf("  sigma of x %.2e m once, %.2e m thirty times\n",
              single.estimate(calibration::Parameter::X).sigma.value_or(0.0),
              repeated.estimate(calibration::Parameter::X).sigma.value_or(0.0));
  EXPECT_NEAR(repeated.estimate(calibration::Parameter::X).sigma.value_or(0.0),
              single.estimate(calibration::Parameter::X).sigma.value_or(1.0),
              0.05 * single.estimate(calibration::Parameter::X).sigma.value_or(1.0));
  EXPECT_EQ(repeated.pairs_accepted, single.pairs_accepted);
  EXPECT_TRUE(std::ranges::any_of(repeated.advice, [](const Message& line) {
    return english(line).find("rows repeat the motions of an earlier one") != std::string::npos;
  }));
  EXPECT_NE(english(often.pairs.back().reason).find("the same motions as in row "), std::string::npos);
}

TEST(motion_pairs_solution, the_height_of_the_ins_is_refused_for_want_of_scans) {
  formats::MotionPairs motions = winding();
  settings::Settings settings;
  settings.measured.ins_height_sigma_m = 0.01;
  Progress progress;
  EXPECT_THROW(solve_motion_pairs(motions.keyframes, motions.pairs, settings, {}, progress), Error);
}

}  // namespace
}  // namespace remount::pipeline
