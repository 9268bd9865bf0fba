// What is claimed without a nominal where a rotation is open: roll on a straight road.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "algorithms/calibration/pairwise.h"
#include "tests/algorithms/support/simulated_drive.h"

namespace remount {
namespace {

CalibrationResult without_nominal(const SimulatedDrive& drive, const DriveOptions& options) {
  std::vector<Pair> pairs = pairs_of(drive);
  return solve_pairwise(input_of(drive, options), pairs, {});
}

// The same drive with a LiDAR that is turned on its mount until X has these angles.
SimulatedDrive turned(SimulatedDrive drive, const YawPitchRoll& angles) {
  const Eigen::Matrix3d old_from_new = drive.ins_from_lidar.linear().transpose() * rotation_from_yaw_pitch_roll(angles);
  const RigidTransform turn = make_rigid(old_from_new, Eigen::Vector3d::Zero());
  for (JointTerm& term : drive.problem.terms)
    term.lidar_b_from_lidar_a = turn.inverse() * term.lidar_b_from_lidar_a * turn;
  drive.ins_from_lidar = drive.ins_from_lidar * turn;
  return drive;
}

TEST(open_rotation, yaw_and_pitch_are_no_better_known_than_the_roll_that_they_turn_with) {
  DriveOptions options;
  options.tilt_rad = options.turn_rad = 0.0;
  for (const double askew_rad : {0.003, 0.03, 0.3}) {
    int claimed = 0;
    double most_sigma = 0.0;
    for (int seed = 1; seed <= 8; ++seed) {
      const SimulatedDrive drive = turned(simulate(options, seed), {askew_rad, -0.7 * askew_rad, 0.1});
      const CalibrationResult result = without_nominal(drive, options);
      const SixParameters is = six_from_rigid(result.ins_from_lidar), truth = six_from_rigid(drive.ins_from_lidar);
      const double off_rad[] = {is.yaw_rad - truth.yaw_rad, is.pitch_rad - truth.pitch_rad};
      for (const std::size_t i : {3U, 4U}) {
        claimed += result.observed[i];
        if (result.observed[i]) most_sigma = std::max(most_sigma, std::abs(off_rad[i - 3]) / *result.sigma(i));
      }
      EXPECT_FALSE(result.observed[5]) << "roll: " << result.message;
    }
    std::printf("  %.3f rad askew: claimed %d of 16, off by up to %.2f sigma\n", askew_rad, claimed, most_sigma);
    EXPECT_LT(most_sigma, 2.5) << askew_rad;
    EXPECT_EQ(claimed, askew_rad < 0.01 ? 16 : 0) << askew_rad;
  }
}

TEST(open_rotation, the_ground_bounds_how_far_yaw_and_pitch_turn_with_roll_where_it_was_seen) {
  DriveOptions options;
  options.tilt_rad = options.turn_rad = 0.0;
  constexpr double kInsLeans_rad = 0.05;
  int claimed = 0, claimed_of_a_wall = 0, claimed_of_nothing = 0;
  double most_sigma = 0.0;
  for (int seed = 1; seed <= 8; ++seed) {
    const SimulatedDrive drive = turned(simulate(options, seed), {0.03, -0.02, 0.1});
    const auto claims = [&](std::optional<Eigen::Vector3d> up_in_lidar) {
      PairwiseInput input = input_of(drive, options);
      input.initial_ins_from_lidar = drive.ins_from_lidar;
      input.initial_ins_from_lidar->linear() =
          so3_exp({kInsLeans_rad, 0.0, 0.0}) * input.initial_ins_from_lidar->linear();
      input.up_in_lidar = up_in_lidar;
      std::vector<Pair> pairs = pairs_of(drive);
      return solve_pairwise(input, pairs, {});
    };
    const Eigen::Vector3d up = drive.ins_from_lidar.linear().transpose() * Eigen::Vector3d::UnitZ();
    const CalibrationResult result = claims(up);
    const SixParameters is = six_from_rigid(result.ins_from_lidar), truth = six_from_rigid(drive.ins_from_lidar);
    const double off_rad[] = {is.yaw_rad - truth.yaw_rad, is.pitch_rad - truth.pitch_rad};
    for (const std::size_t i : {3U, 4U}) {
      claimed += result.observed[i];
      if (result.observed[i]) most_sigma = std::max(most_sigma, std::abs(off_rad[i - 3]) / *result.sigma(i));
    }
    const CalibrationResult wall = claims(so3_exp({0.6, 0.0, 0.0}) * up), nothing = claims(std::nullopt);
    for (const std::size_t i : {3U, 4U}) {
      claimed_of_a_wall += wall.observed[i];
      claimed_of_nothing += nothing.observed[i];
    }
  }
  std::printf("  claimed %d of 16, off by up to %.2f sigma; %d by a wall, %d without ground\n", claimed, most_sigma,
              claimed_of_a_wall, claimed_of_nothing);
  EXPECT_EQ(claimed, 16);
  EXPECT_LT(most_sigma, 2.5);
  EXPECT_EQ(claimed_of_a_wall, 0) << "X and what is taken for the ground contradict each other";
  EXPECT_EQ(claimed_of_nothing, 0) << "a first X that rests on nothing settles nothing";
}

}  // namespace
}  // namespace remount
