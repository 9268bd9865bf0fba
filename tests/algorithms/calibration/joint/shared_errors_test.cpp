#include "algorithms/calibration/joint/shared_errors.h"

#include <gtest/gtest.h>

#include <cmath>
#include <iostream>

#include "tests/algorithms/support/simulated_drive.h"
#include "tests/algorithms/support/size_of_error.h"

namespace remount::calibration {
namespace {

constexpr double kUsual_m = 1.2e-4, kUsual_rad = 1.8e-5;

double longest_m(const JointProblem& problem) {
  double longest = 0.0;
  for (const JointTerm& term : problem.terms)
    longest = std::max(longest, term.lidar_b_from_lidar_a.translation().norm());
  return longest;
}

/// Gives all registrations the same errors: one for the shortest motions, one for the longest.
void add_shared_error(JointProblem& problem, const Vector6d& nearest, const Vector6d& farthest) {
  const double longest = longest_m(problem);
  for (JointTerm& term : problem.terms) {
    const double share = term.lidar_b_from_lidar_a.translation().norm() / longest;
    term.lidar_b_from_lidar_a = perturb(term.lidar_b_from_lidar_a, (1.0 - share) * nearest + share * farthest);
  }
}

/// A bend that hardly changes, with an INS that could hardly be better: a tunnel.
testing::DriveOptions bend() {
  testing::DriveOptions options;
  options.keyframes = 30;
  options.partners = 6;
  options.step_s = 0.1;
  options.turn_rad = 0.1;
  options.tilt_rad = 0.01;
  options.noise.ins_position_sigma_m = 1e-3;
  options.noise.ins_attitude_sigma_rad = 2e-5;
  options.noise.registration_scale = 0.3;
  options.noise.registration_floor_m = 3e-4;
  options.noise.registration_floor_rad = 3e-5;
  return options;
}

TEST(shared_errors, responses_are_how_x_moves_where_all_registrations_are_wrong_alike) {
  testing::DriveOptions options;
  options.sessions = 2;
  options.attitude_bias_sigma_rad = 1e-3;
  options.noise.ins_attitude_drift = 1e-4;
  const testing::SimulatedDrive drive = testing::simulate(options, 1);
  const JointSolution solution = solve_joint(drive.problem, options.noise, testing::mounting(), 20, {});
  const SharedErrors errors = shared_errors(drive.problem, options.noise, solution);
  ASSERT_GT(errors.size, 0.0);
  for (int column = 0; column < 12; ++column) {
    Eigen::Matrix<double, 12, 1> given = Eigen::Matrix<double, 12, 1>::Zero();
    given[column] = errors.size * (column % 6 < 3 ? kUsual_m : kUsual_rad);
    JointProblem wrong = drive.problem;
    add_shared_error(wrong, given.head<6>(), given.tail<6>());
    const JointSolution moved = solve_joint(wrong, options.noise, solution.ins_from_lidar, 20, {});
    const Vector6d change = difference(solution.ins_from_lidar, moved.ins_from_lidar);
    EXPECT_LT((change - errors.responses.col(column)).norm(), 0.02 * change.norm() + 1e-8)
        << column << ": " << change.transpose() << " against " << errors.responses.col(column).transpose();
  }
}

TEST(shared_errors, sigma_holds_with_them_and_would_not_without) {
  const testing::DriveOptions options = bend();
  constexpr int kDrives = 40;
  for (const double size : {0.0, 4.0}) {
    double with = 0.0, without = 0.0, mean_size = 0.0;
    std::mt19937_64 random(7);
    for (int seed = 1; seed <= kDrives; ++seed) {
      testing::SimulatedDrive drive = testing::simulate(options, seed);
      const Vector6d nearest = testing::random_step(random, size * kUsual_m, size * kUsual_rad);
      add_shared_error(drive.problem, nearest, testing::random_step(random, size * kUsual_m, size * kUsual_rad));
      const JointSolution solution = solve_joint(drive.problem, options.noise, testing::mounting(), 20, {});
      ASSERT_TRUE(solution.converged);
      const SharedErrors errors = shared_errors(drive.problem, options.noise, solution);
      const Vector6d off = difference(solution.ins_from_lidar, drive.ins_from_lidar);
      const Matrix6d covariance = solution.covariance + errors.responses * errors.responses.transpose();
      without += testing::squared_over_sigma(off, solution.covariance) / kDrives;
      with += testing::squared_over_sigma(off, covariance) / kDrives;
      mean_size += errors.size / kDrives;
    }
    std::cout << "  errors " << size << " times the usual: estimated " << mean_size << "; chi-square of six " << with
              << ", without them " << without << "\n";
    EXPECT_GT(with, 2.0);
    EXPECT_LT(with, 9.0);
    if (size > 0.0) {
      EXPECT_NEAR(mean_size / size, 1.0, 0.35);
      EXPECT_GT(without, 2.0 * with);
    } else {
      EXPECT_LT(mean_size, 1.0);
    }
  }
}

TEST(shared_errors, a_problem_without_pairs_has_none) {
  JointProblem empty;
  EXPECT_EQ(shared_errors(empty, NoiseModel{}, {}).responses.norm(), 0.0);
}

}  // namespace
}  // namespace remount::calibration
