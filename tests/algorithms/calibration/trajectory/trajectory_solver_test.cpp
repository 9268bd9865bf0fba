#include "algorithms/calibration/trajectory/trajectory_solver.h"

#include <gtest/gtest.h>

#include <cstdio>

#include "algorithms/calibration/trajectory/trajectory_alignment.h"
#include "algorithms/messages/render.h"
#include "tests/algorithms/support/trajectory_drive.h"

namespace remount::calibration {
namespace {

TEST(trajectory_solver, an_odometry_of_another_drive_is_not_aligned) {
  for (const double turn_rad : {-1.2, 0.5, 2.0})
    for (const double later_s : {0.0, 37.0}) {
      testing::TrajectoryDriveOptions drive, other;
      other.turn_rad = turn_rad;
      TrajectoryProblem problem;
      problem.sessions.push_back(testing::trajectory_session(drive));
      for (TrajectoryEpoch& epoch : problem.sessions.front().epochs)
        epoch.odometry_from_lidar =
            testing::true_pose(other, later_s).inverse() * testing::true_pose(other, later_s + epoch.time_s);
      const TrajectoryOutcome outcome = solve_alignment(problem, {}, {}, Progress{});
      std::printf("  turns of %.1f rad, %.0f s later: %s; factors", turn_rad, later_s,
                  std::string(to_string(outcome.answer.result.status)).c_str());
      for (const double factor : outcome.solution.noise.factor) std::printf(" %.2f", factor);
      std::printf("\n");
      EXPECT_EQ(outcome.answer.result.status, Status::NotConverged) << english(outcome.answer.result.message);
    }
}

TEST(trajectory_solver, what_has_converged_from_a_start_far_off_is_the_minimum) {
  const testing::TrajectoryDriveOptions drive;
  TrajectoryProblem problem;
  problem.sessions.push_back(testing::trajectory_session(drive));
  TrajectorySolution good;
  for (const TrajectoryEpoch& epoch : problem.sessions.front().epochs) {
    if (good.state.enu_from_lidar.empty()) good.state.enu_from_lidar.emplace_back();
    good.state.enu_from_lidar.front().push_back(testing::true_pose(drive, epoch.time_s));
  }
  good.state.ins_from_lidar = drive.ins_from_lidar;
  good.state.scale = good.state.clock_s = {0.0};
  // Without a kernel there are no other minima near.
  TrajectoryOptions options;
  options.outlier_threshold = 1e6;
  const TrajectoryPrior prior = weak_trajectory_prior(problem, options, drive.ins_from_lidar);
  TrajectoryApproach approach;
  approach.graduated = approach.estimate_noise = false;
  const TrajectorySolution reached = solve_trajectory(problem, options, good, prior, approach, {});
  ASSERT_TRUE(reached.converged);
  for (const double away_rad : {0.1, 0.5, 1.05, 2.0, 3.0})
    for (int axis = 0; axis < 3; ++axis) {
      TrajectorySolution start = good;
      start.state.ins_from_lidar.linear() *= so3_exp(away_rad * Eigen::Vector3d::Unit(axis));
      const TrajectorySolution found = solve_trajectory(problem, options, start, prior, approach, {});
      const double off = difference(reached.state.ins_from_lidar, found.state.ins_from_lidar).cwiseAbs().maxCoeff();
      std::printf("  %.2f rad about axis %d: %s after %d, %.2g off\n", away_rad, axis,
                  found.converged ? "converged" : "not converged", found.iterations, off);
      if (found.converged) {
        EXPECT_LT(off, 1e-4);
      }
      if (away_rad < 0.2) {
        EXPECT_TRUE(found.converged);
      }
    }
}

// Noise of attitudes shows z on flat ground as little as its linear residuals say, and bends the cost as much: steps by
// linear residuals alone ended without an answer after 180 to 300 of them in a third of these drives.
TEST(trajectory_solver, flat_ground_and_noisy_attitudes_are_aligned_after_few_steps) {
  for (unsigned seed = 5; seed <= 12; ++seed) {
    testing::TrajectoryDriveOptions drive;
    drive.seed = seed;
    drive.duration_s = 40.0;
    drive.interval_s = 0.2;
    drive.turn_rad = 0.7;
    drive.slope_rad = 0.0;
    drive.attitude_sigma_rad = degrees_to_radians(0.3);
    drive.step_sigma_m = 0.003;
    drive.step_sigma_rad = 0.005;
    TrajectoryProblem problem;
    problem.sessions.push_back(testing::trajectory_session(drive));
    problem.sessions.front().ins_noise_stated = true;
    const TrajectoryOutcome outcome = solve_alignment(problem, {}, {}, Progress{});
    std::printf("  seed %u: %s after %d steps\n", seed, outcome.solution.converged ? "converged" : "not converged",
                outcome.solution.iterations);
    EXPECT_TRUE(outcome.solution.converged);
    EXPECT_EQ(outcome.answer.result.status, Status::Degenerate) << english(outcome.answer.result.message);
    EXPECT_LT(outcome.solution.iterations, 100);
  }
}

TEST(trajectory_solver, stated_errors_are_not_believed_to_be_smaller) {
  testing::TrajectoryDriveOptions smooth;
  smooth.noise = false;
  for (const bool stated : {false, true}) {
    TrajectoryProblem problem;
    problem.sessions.push_back(testing::trajectory_session(smooth));
    problem.sessions.front().ins_noise_stated = stated;
    const TrajectoryNoise noise = solve_alignment(problem, {}, {}, Progress{}).solution.noise;
    for (const TermKind kind : {TermKind::InsPosition, TermKind::InsAttitude})
      if (stated)
        EXPECT_GE(noise.of(kind), 1.0);
      else
        EXPECT_LT(noise.of(kind), 0.5);
  }
}

}  // namespace
}  // namespace remount::calibration
