// What is claimed without a nominal where a rotation is open: roll on a straight road.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "algorithms/calibration/pairwise/pairwise.h"
#include "algorithms/calibration/trajectory/trajectory_alignment.h"
#include "algorithms/messages/render.h"
#include "tests/algorithms/support/simulated_drive.h"
#include "tests/algorithms/support/trajectory_drive.h"

namespace remount::calibration {
namespace {

CalibrationResult without_nominal(const testing::SimulatedDrive& drive, const testing::DriveOptions& options) {
  std::vector<motion::Pair> pairs = testing::pairs_of(drive);
  return solve_pairwise(testing::input_of(drive, options), pairs, {});
}

// The same drive with a LiDAR that is turned on its mount until X has these angles.
testing::SimulatedDrive turned(testing::SimulatedDrive drive, const YawPitchRoll& angles) {
  const Eigen::Matrix3d old_from_new = drive.ins_from_lidar.linear().transpose() * rotation_from_yaw_pitch_roll(angles);
  const RigidTransform turn = make_rigid(old_from_new, Eigen::Vector3d::Zero());
  for (JointTerm& term : drive.problem.terms)
    term.lidar_b_from_lidar_a = turn.inverse() * term.lidar_b_from_lidar_a * turn;
  drive.ins_from_lidar = drive.ins_from_lidar * turn;
  return drive;
}

TEST(open_rotation, yaw_and_pitch_are_no_better_known_than_the_roll_that_they_turn_with) {
  testing::DriveOptions options;
  options.tilt_rad = options.turn_rad = 0.0;
  for (const double askew_rad : {0.003, 0.03, 0.3}) {
    int claimed = 0;
    double most_sigma = 0.0;
    for (int seed = 1; seed <= 8; ++seed) {
      const testing::SimulatedDrive drive =
          turned(testing::simulate(options, seed), {askew_rad, -0.7 * askew_rad, 0.1});
      const CalibrationResult result = without_nominal(drive, options);
      const SixParameters is = six_from_rigid(result.mounting.reference_from_sensor),
                          truth = six_from_rigid(drive.ins_from_lidar);
      const double off_rad[] = {is.yaw_rad - truth.yaw_rad, is.pitch_rad - truth.pitch_rad};
      for (const std::size_t i : {3U, 4U}) {
        claimed += result.known[kParameters[i]].observed;
        if (result.known[kParameters[i]].observed)
          most_sigma = std::max(most_sigma, std::abs(off_rad[i - 3]) / *result.estimate(kParameters[i]).sigma);
      }
      EXPECT_FALSE(result.known[Parameter::Roll].observed) << "roll: " << english(result.message);
    }
    std::printf("  %.3f rad askew: claimed %d of 16, off by up to %.2f sigma\n", askew_rad, claimed, most_sigma);
    EXPECT_LT(most_sigma, 2.5) << askew_rad;
    EXPECT_EQ(claimed, askew_rad < 0.01 ? 16 : 0) << askew_rad;
  }
}

TEST(open_rotation, the_ground_bounds_how_far_yaw_and_pitch_turn_with_roll_where_it_was_seen) {
  testing::DriveOptions options;
  options.tilt_rad = options.turn_rad = 0.0;
  constexpr double kInsLeans_rad = 0.05;
  int claimed = 0, claimed_of_a_wall = 0, claimed_of_nothing = 0;
  double most_sigma = 0.0;
  for (int seed = 1; seed <= 8; ++seed) {
    const testing::SimulatedDrive drive = turned(testing::simulate(options, seed), {0.03, -0.02, 0.1});
    const auto claims = [&](std::optional<Eigen::Vector3d> up_in_lidar) {
      PairwiseInput input = testing::input_of(drive, options);
      input.initial_ins_from_lidar = drive.ins_from_lidar;
      input.initial_ins_from_lidar->linear() =
          so3_exp({kInsLeans_rad, 0.0, 0.0}) * input.initial_ins_from_lidar->linear();
      input.up_in_lidar = up_in_lidar;
      std::vector<motion::Pair> pairs = testing::pairs_of(drive);
      return solve_pairwise(input, pairs, {});
    };
    const Eigen::Vector3d up = drive.ins_from_lidar.linear().transpose() * Eigen::Vector3d::UnitZ();
    const CalibrationResult result = claims(up);
    const SixParameters is = six_from_rigid(result.mounting.reference_from_sensor),
                        truth = six_from_rigid(drive.ins_from_lidar);
    const double off_rad[] = {is.yaw_rad - truth.yaw_rad, is.pitch_rad - truth.pitch_rad};
    for (const std::size_t i : {3U, 4U}) {
      claimed += result.known[kParameters[i]].observed;
      if (result.known[kParameters[i]].observed)
        most_sigma = std::max(most_sigma, std::abs(off_rad[i - 3]) / *result.estimate(kParameters[i]).sigma);
    }
    const CalibrationResult wall = claims(so3_exp({0.6, 0.0, 0.0}) * up), nothing = claims(std::nullopt);
    for (const std::size_t i : {3U, 4U}) {
      claimed_of_a_wall += wall.known[kParameters[i]].observed;
      claimed_of_nothing += nothing.known[kParameters[i]].observed;
    }
  }
  std::printf("  claimed %d of 16, off by up to %.2f sigma; %d by a wall, %d without ground\n", claimed, most_sigma,
              claimed_of_a_wall, claimed_of_nothing);
  EXPECT_EQ(claimed, 16);
  EXPECT_LT(most_sigma, 2.5);
  EXPECT_EQ(claimed_of_a_wall, 0) << "X and what is taken for the ground contradict each other";
  EXPECT_EQ(claimed_of_nothing, 0) << "a first X that rests on nothing settles nothing";
}

const RigidTransform kAskew = rigid_from_six({0.85, 0.33, 0.95, -0.13, 0.03, -0.04});

// A straight road along the x of the INS as `trajectory` sees it, by a LiDAR that is askew.
TrajectoryProblem straight_road(unsigned seed, bool ground_seen) {
  testing::TrajectoryDriveOptions drive;
  drive.duration_s = 22.0;
  drive.interval_s = 0.2;
  drive.turn_rad = drive.slope_rad = 0.0;
  drive.ins_from_lidar = make_rigid(Eigen::Matrix3d::Identity(), kAskew.translation());
  drive.seed = seed;
  TrajectoryProblem problem;
  problem.sessions.push_back(testing::trajectory_session(drive));
  const RigidTransform turn = make_rigid(kAskew.linear(), Eigen::Vector3d::Zero());
  for (TrajectoryEpoch& epoch : problem.sessions.back().epochs)
    epoch.odometry_from_lidar = turn.inverse() * epoch.odometry_from_lidar * turn;
  if (ground_seen) problem.up_in_lidar = kAskew.linear().transpose() * Eigen::Vector3d::UnitZ();
  return problem;
}

TEST(open_rotation, trajectory_claims_no_yaw_and_pitch_that_turn_with_an_open_roll) {
  const SixParameters truth = six_from_rigid(kAskew);
  for (const bool ground_seen : {false, true}) {
    int claimed = 0;
    double most_sigma = 0.0, most_roll_rad = 0.0;
    for (unsigned seed = 11; seed <= 18; ++seed) {
      const CalibrationResult result =
          solve_alignment(straight_road(seed, ground_seen), {}, {}, Progress{}).answer.result;
      ASSERT_TRUE(is_usable(result) || !result.known[Parameter::Yaw].observed) << english(result.message);
      const SixParameters is = six_from_rigid(result.mounting.reference_from_sensor);
      const double off_rad[] = {is.yaw_rad - truth.yaw_rad, is.pitch_rad - truth.pitch_rad,
                                is.roll_rad - truth.roll_rad};
      for (const std::size_t i : {3U, 4U, 5U}) {
        claimed += result.known[kParameters[i]].observed;
        if (result.known[kParameters[i]].observed)
          most_sigma = std::max(most_sigma, std::abs(off_rad[i - 3]) / *result.estimate(kParameters[i]).sigma);
      }
      most_roll_rad = std::max(most_roll_rad, std::abs(wrap_angle_rad(off_rad[2])));
    }
    std::printf("  ground %s: claimed %d of 24, off by up to %.2f sigma; roll off by up to %.3f rad\n",
                ground_seen ? "seen" : "not seen", claimed, most_sigma, most_roll_rad);
    EXPECT_LT(most_sigma, 3.5);
    if (ground_seen) {
      EXPECT_LT(most_roll_rad, 0.2) << "the ground says where up is";
    } else {
      EXPECT_EQ(claimed, 0) << "nothing says where up is";
    }
  }
}

}  // namespace
}  // namespace remount::calibration
