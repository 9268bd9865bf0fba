#include "algorithms/calibration/pairwise/motion_agreement.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>

#include "algorithms/messages/render.h"
#include "tests/algorithms/support/simulated_drive.h"

namespace remount::calibration {
namespace {

CalibrationResult solved_with(const testing::SimulatedDrive& drive, const testing::DriveOptions& options,
                              std::vector<motion::Pair> pairs) {
  PairwiseInput input = testing::input_of(drive, options);
  input.nominal_ins_from_lidar = testing::mounting();
  return solve_pairwise(input, pairs, {});
}

bool advises(const CalibrationResult& result, const std::string& words) {
  return std::any_of(result.advice.begin(), result.advice.end(),
                     [&](const Message& advice) { return english(advice).find(words) != std::string::npos; });
}

TEST(motion_agreement, of_a_sound_drive_nothing_is_said) {
  const testing::DriveOptions options;
  for (int seed = 1; seed <= 5; ++seed) {
    const testing::SimulatedDrive drive = testing::simulate(options, seed);
    const CalibrationResult result = solved_with(drive, options, testing::pairs_of(drive));
    EXPECT_EQ(result.status, Status::Ok) << english(result.message);
    EXPECT_FALSE(advises(result, "times as far")) << english(result.advice.front());
  }
}

TEST(motion_agreement, an_odometry_that_measures_distances_wrongly_is_named_and_widens_sigma) {
  const testing::DriveOptions options;
  for (const double scale : {1.01, 1.03, 0.97}) {
    const testing::SimulatedDrive drive = testing::simulate(options, 4);
    std::vector<motion::Pair> pairs = testing::pairs_of(drive);
    for (motion::Pair& pair : pairs) pair.lidar_b_from_lidar_a.translation() *= scale;
    const CalibrationResult result = solved_with(drive, options, pairs);
    const Eigen::Vector3d off_m =
        result.mounting.reference_from_sensor.translation() - drive.ins_from_lidar.translation();
    std::printf("  %.2f: off by %.3f %.3f %.3f m\n", scale, off_m.x(), off_m.y(), off_m.z());
    EXPECT_TRUE(advises(result, "times as far")) << scale << " " << english(result.message);
    ASSERT_TRUE(result.estimate(Parameter::X).sigma) << english(result.message);
    for (std::size_t i = 0; i < 3; ++i) {
      if (!result.estimate(kParameters[i]).sigma) continue;
      EXPECT_LT(std::abs(off_m[static_cast<Eigen::Index>(i)]), 3.5 * *result.estimate(kParameters[i]).sigma)
          << to_string(kParameters[i]);
    }
  }
}

TEST(motion_agreement, poses_of_another_convention_give_no_result) {
  const testing::DriveOptions options;
  const testing::SimulatedDrive drive = testing::simulate(options, 5);
  std::vector<motion::Pair> inverse = testing::pairs_of(drive), turned = inverse;
  for (motion::Pair& pair : inverse) pair.lidar_b_from_lidar_a = pair.lidar_b_from_lidar_a.inverse();
  const RigidTransform mirror = make_rigid(so3_exp({0.5 * kPi, 0.0, 0.0}), Eigen::Vector3d::Zero());
  for (motion::Pair& pair : turned)
    pair.lidar_b_from_lidar_a.linear() = mirror.linear() * pair.lidar_b_from_lidar_a.linear();
  for (const std::vector<motion::Pair>& pairs : {inverse, turned}) {
    const CalibrationResult result = solved_with(drive, options, pairs);
    std::printf("  %s\n", english(result.message).c_str());
    EXPECT_NE(result.status, Status::Ok);
    EXPECT_EQ(parameter_names(result.observed()), "") << english(result.message);
  }
}

TEST(motion_agreement, a_unit_that_is_not_the_metre_is_named_with_the_factor) {
  const testing::DriveOptions options;
  const testing::SimulatedDrive drive = testing::simulate(options, 6);
  for (const double scale : {100.0, 3.28084, 0.001}) {
    std::vector<motion::Pair> by_lidar = testing::pairs_of(drive), by_ins = by_lidar;
    for (motion::Pair& pair : by_lidar) pair.lidar_b_from_lidar_a.translation() *= scale;
    for (motion::Pair& pair : by_ins) pair.ins_b_from_ins_a.translation() /= scale;
    for (const std::vector<motion::Pair>& pairs : {by_lidar, by_ins}) {
      const CalibrationResult result = solved_with(drive, options, pairs);
      const double factor = lidar_per_ins_way(pairs);
      std::printf("  %.4g: %.4g, %s\n", scale, factor, english(result.message).c_str());
      EXPECT_NEAR(factor / scale, 1.0, 0.1);
      EXPECT_EQ(result.status, Status::Inconsistent) << scale;
      EXPECT_NE(
          english(result.message).find(scale > 1.0 ? "The motions of the LiDAR are" : "The motions of the INS are"),
          std::string::npos)
          << result.message;
      EXPECT_EQ(parameter_names(result.observed()), "") << result.message;
      EXPECT_TRUE(advises(result, "Look at the units of the LiDAR's poses"));
    }
  }
}

// A LiDAR at the end of an arm goes farther than an INS near the axis, whatever the unit.
TEST(motion_agreement, an_arm_that_turns_is_no_other_unit) {
  std::vector<motion::Pair> pairs(20);
  const RigidTransform arm = make_rigid(Eigen::Matrix3d::Identity(), {4.0, 0.0, 1.0});
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    pairs[i].registration.converged = true;
    pairs[i].ins_b_from_ins_a = make_rigid(so3_exp({0.0, 0.0, 0.1 + 0.001 * static_cast<double>(i)}), {0.1, 0.0, 0.0});
    pairs[i].lidar_b_from_lidar_a = arm.inverse() * pairs[i].ins_b_from_ins_a * arm;
  }
  EXPECT_EQ(lidar_per_ins_way(pairs), 1.0);
  for (motion::Pair& pair : pairs) pair.lidar_b_from_lidar_a.translation() *= 1000.0;
  EXPECT_GT(lidar_per_ins_way(pairs), 100.0);
}

TEST(motion_agreement, says_how_far_and_how_differently_both_move) {
  std::vector<motion::Pair> pairs(4);
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    pairs[i].state = motion::PairState::Accepted;
    pairs[i].ins_b_from_ins_a.translation() = Eigen::Vector3d(3.0, i % 2 == 0 ? 4.0 : -4.0, 0.0);
    pairs[i].lidar_b_from_lidar_a.translation() = 1.1 * pairs[i].ins_b_from_ins_a.translation();
  }
  pairs[3].registration.undetermined = Message::verbatim("x (axes of the lidar)");
  pairs[3].lidar_b_from_lidar_a.translation().x() = 100.0;
  const MotionAgreement agreement = motion_agreement(pairs, RigidTransform::Identity());
  EXPECT_NEAR(agreement.travel_m, 5.0, 1e-12);
  EXPECT_NEAR(agreement.apart_m, 0.5, 1e-6);
  EXPECT_NEAR(agreement.lidar_per_ins, 1.1, 1e-12);
  EXPECT_LT(agreement.lidar_per_ins_sigma, 1e-6);
  pairs.resize(2);
  EXPECT_TRUE(std::isinf(motion_agreement(pairs, RigidTransform::Identity()).lidar_per_ins_sigma));
}

}  // namespace
}  // namespace remount::calibration
