#include "algorithms/calibration/joint/measurement_pulls.h"

#include <gtest/gtest.h>

#include <cstdio>

#include "tests/algorithms/support/simulated_drive.h"

namespace remount::calibration {
namespace {

// A drive with offset and lag of each session as unknowns.
testing::SimulatedDrive with_times(const testing::DriveOptions& options, int seed) {
  testing::SimulatedDrive drive = testing::simulate(options, seed);
  for (JointNode& node : drive.problem.nodes) node.body_velocity = testing::true_velocity(options, node.time_s);
  drive.problem.estimate_time_offset = true;
  drive.problem.session_position_lag_sigma_s.assign(static_cast<std::size_t>(options.sessions), 1.0);
  return drive;
}

// What is pulled in one direction and the other is together as large as sigma says, less what the unknowns take up.
TEST(measurement_pulls, of_times_scatter_as_sigma_says) {
  testing::DriveOptions options;
  options.sessions = 2;
  Eigen::Vector2d ratios = Eigen::Vector2d::Zero();
  constexpr int kProblems = 20;
  for (int seed = 1; seed <= kProblems; ++seed) {
    const testing::SimulatedDrive drive = with_times(options, seed);
    const JointSolution solution = solve_joint(drive.problem, options.noise, drive.ins_from_lidar, 30, {});
    ASSERT_EQ(solution.position_lag_sigma_s.size(), 2U);
    const MeasurementPulls pulls(drive.problem, options.noise, solution, {});
    for (motion::SessionIndex session; session < 2; ++session) {
      Eigen::Vector2d squares = Eigen::Vector2d::Zero();
      for (const MeasurementPull& pull : pulls.of_times(session)) squares += pull.step.cwiseAbs2();
      const Eigen::Vector2d sigmas_s(solution.time_offset_sigma_s[session], solution.position_lag_sigma_s[session]);
      ratios += squares.cwiseQuotient(sigmas_s.cwiseAbs2()) / (2.0 * kProblems);
    }
  }
  for (int i = 0; i < 2; ++i) {
    EXPECT_GT(ratios[i], 0.3) << (i == 0 ? "offset" : "lag");
    EXPECT_LT(ratios[i], 1.2) << (i == 0 ? "offset" : "lag");
  }
  std::printf("pulls over sigma, squared: offset %.2f, lag %.2f\n", ratios[0], ratios[1]);
}

TEST(measurement_pulls, of_a_lag_that_moves_x_are_as_the_covariance_says) {
  testing::DriveOptions options;
  const testing::SimulatedDrive drive = with_times(options, 4);
  const JointSolution solution = solve_joint(drive.problem, options.noise, drive.ins_from_lidar, 30, {});
  ASSERT_EQ(solution.moved_by_position_lag.size(), 1U);
  // X where the lag is held elsewhere.
  JointProblem held = drive.problem;
  held.session_position_lag_sigma_s.assign(1, 1e-9);
  const JointSolution at_zero = solve_joint(held, options.noise, drive.ins_from_lidar, 30, {});
  const Vector6d change = difference(at_zero.ins_from_lidar, solution.ins_from_lidar) / solution.position_lag_s[0];
  EXPECT_LT((change - solution.moved_by_position_lag[0]).norm(), 0.05 * change.norm())
      << change.transpose() << " against " << solution.moved_by_position_lag[0].transpose();
}

}  // namespace
}  // namespace remount::calibration
