#include "algorithms/calibration/joint/measurement_pulls.h"

#include <gtest/gtest.h>

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

// How far one registration pulls the offset and the lag of the session it is of is how far these move where it counts
// more.
TEST(measurement_pulls, of_times_are_how_offset_and_lag_move) {
  testing::DriveOptions options;
  options.sessions = 2;
  const testing::SimulatedDrive drive = with_times(options, 3);
  const JointSolution solution = solve_joint(drive.problem, options.noise, drive.ins_from_lidar, 30, {});
  ASSERT_TRUE(solution.converged);
  const MeasurementPulls pulls(drive.problem, options.noise, solution, {});
  constexpr double kMore = 0.1;  // the solution is as sharp as a ten-thousandth of its sigma
  for (motion::SessionIndex session; session < 2; ++session) {
    const std::vector<MeasurementPull> of_session = pulls.of_times(session);
    std::size_t first = 0;  // of the terms, which come before the keyframes
    while (drive.problem.nodes[drive.problem.terms[first].node_a].session != session) ++first;
    JointProblem more = drive.problem;
    more.terms[first].weight += kMore;
    const JointSolution moved = solve_joint(more, options.noise, solution.ins_from_lidar, 30, {});
    const Eigen::Vector2d change = Eigen::Vector2d(moved.time_offset_s[session] - solution.time_offset_s[session],
                                                   moved.position_lag_s[session] - solution.position_lag_s[session]) /
                                   kMore;
    ASSERT_EQ(of_session.size() > 0 ? of_session.front().step.size() : 0, 2);
    ASSERT_EQ(moved.position_lag_s.size(), 2U);
    EXPECT_LT((change - of_session.front().step).norm(), 0.05 * change.norm())
        << "session " << session << ": " << change.transpose() << " against " << of_session.front().step.transpose();
  }
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
  const Vector6d change =
      remount::difference(at_zero.ins_from_lidar, solution.ins_from_lidar) / solution.position_lag_s[0];
  EXPECT_LT((change - solution.moved_by_position_lag[0]).norm(), 0.05 * change.norm())
      << change.transpose() << " against " << solution.moved_by_position_lag[0].transpose();
}

}  // namespace
}  // namespace remount::calibration
