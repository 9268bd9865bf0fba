#include "algorithms/calibration/joint/joint_solver.h"

#include <gtest/gtest.h>

#include <cmath>

#include "algorithms/calibration/joint/measurement_pulls.h"
#include "algorithms/calibration/joint/pair_equation.h"
#include "algorithms/core/symmetric_eigen.h"
#include "tests/algorithms/support/simulated_drive.h"
#include "tests/algorithms/support/size_of_error.h"

namespace remount::calibration {
namespace {

const RigidTransform kOff = perturb(testing::mounting(), (Vector6d() << 0.1, -0.1, 0.1, 0.03, -0.02, 0.03).finished());

double normalised_error2(const JointSolution& solution, const RigidTransform& truth) {
  const Vector6d error = difference(solution.ins_from_lidar, truth);
  return testing::squared_over_sigma(error, solution.covariance);
}

// Mean of the normalised squared error of X over problems with different noise; six where covariance and errors agree.
double mean_normalised_error2(const testing::DriveOptions& options, const NoiseModel& assumed, int problems) {
  double sum = 0.0;
  for (int seed = 1; seed <= problems; ++seed) {
    const testing::SimulatedDrive drive = testing::simulate(options, seed);
    const JointSolution solution = solve_joint(drive.problem, assumed, kOff, 20, {});
    EXPECT_TRUE(solution.converged) << "seed " << seed;
    sum += normalised_error2(solution, drive.ins_from_lidar);
  }
  return sum / problems;
}

TEST(joint_solver, is_exact_on_exact_data) {
  testing::DriveOptions options;
  options.noise = testing::no_noise();
  const testing::SimulatedDrive drive = testing::simulate(options, 1);
  const JointSolution solution = solve_joint(drive.problem, NoiseModel{}, kOff, 20, {});
  EXPECT_TRUE(solution.converged);
  EXPECT_LT(testing::distance_of(solution.ins_from_lidar, drive.ins_from_lidar), 1e-7);
  for (const Vector6d& error : solution.node_errors) EXPECT_LT(error.norm(), 1e-7);
}

TEST(joint_solver, errors_are_consistent_with_the_covariance) {
  // 60 problems of six degrees of freedom: the mean scatters by 0.45 about 6.
  const testing::DriveOptions options;
  const double mean = mean_normalised_error2(options, options.noise, 60);
  EXPECT_GT(mean, 4.6);
  EXPECT_LT(mean, 7.4);
}

TEST(joint_solver, errors_are_consistent_where_the_ins_drifts_and_optimistic_where_that_is_not_modelled) {
  testing::DriveOptions options;
  options.noise.ins_position_drift = 0.05;
  options.noise.ins_attitude_drift = 1e-3;
  const double mean = mean_normalised_error2(options, options.noise, 30);
  EXPECT_GT(mean, 4.0);
  EXPECT_LT(mean, 8.0);
  EXPECT_GT(mean_normalised_error2(options, NoiseModel{}, 30), 2.0 * mean);
}

TEST(joint_solver, errors_are_consistent_with_attitude_errors_that_stay_over_a_drive) {
  testing::DriveOptions options;
  options.sessions = 3;
  options.keyframes = 20;
  options.attitude_bias_sigma_rad = 3e-3;
  const double mean = mean_normalised_error2(options, options.noise, 30);
  EXPECT_GT(mean, 4.0);
  EXPECT_LT(mean, 8.0);
}

TEST(joint_solver, pulls_are_how_x_moves_where_a_measurement_counts_more) {
  testing::DriveOptions options;
  options.noise.ins_attitude_drift = 1e-4;
  testing::SimulatedDrive drive = testing::simulate(options, 1);
  const JointSolution solution = solve_joint(drive.problem, options.noise, kOff, 20, {});
  const std::vector<MeasurementPull> pulls = MeasurementPulls(drive.problem, options.noise, solution, {}).of_mounting();
  ASSERT_EQ(pulls.size(), drive.problem.terms.size() + drive.problem.nodes.size());
  constexpr double kMore = 1e-3;
  for (const std::size_t term : {std::size_t{0}, drive.problem.terms.size() / 2}) {
    JointProblem more = drive.problem;
    more.terms[term].weight += kMore;
    const JointSolution moved = solve_joint(more, options.noise, solution.ins_from_lidar, 20, {});
    const Vector6d change = difference(solution.ins_from_lidar, moved.ins_from_lidar) / kMore;
    EXPECT_LT((change - pulls[term].step).norm(), 0.02 * change.norm())
        << change.transpose() << " against " << pulls[term].step.transpose();
  }
}

TEST(joint_solver, pulls_balance_and_scatter_as_the_covariance_says) {
  testing::DriveOptions options;
  options.noise.ins_position_drift = 0.02;
  Vector6d ratios2 = Vector6d::Zero();
  constexpr int kProblems = 20;
  for (int seed = 1; seed <= kProblems; ++seed) {
    const testing::SimulatedDrive drive = testing::simulate(options, seed);
    const JointSolution solution = solve_joint(drive.problem, options.noise, kOff, 20, {});
    Vector6d sum = Vector6d::Zero(), squares = Vector6d::Zero();
    for (const MeasurementPull& pull : MeasurementPulls(drive.problem, options.noise, solution, {}).of_mounting()) {
      sum += pull.step;
      squares += pull.step.cwiseAbs2();
    }
    const Vector6d variances = solution.covariance.diagonal();
    EXPECT_LT(sum.cwiseAbs2().cwiseQuotient(variances).maxCoeff(), 0.01) << "seed " << seed;
    ratios2 += squares.cwiseQuotient(variances) / kProblems;
  }
  // Residuals are smaller than errors by what the unknowns take up: six of each keyframe's measurements.
  for (int i = 0; i < 6; ++i) {
    EXPECT_GT(ratios2[i], 0.4) << i;
    EXPECT_LT(ratios2[i], 1.1) << i;
  }
}

TEST(joint_solver, a_fix_that_enters_many_pairs_is_counted_once) {
  // More partners for each keyframe repeat the same fixes: where their noise dominates, sigma stays.
  testing::DriveOptions few, many;
  few.noise.registration_scale = many.noise.registration_scale = 0.1;
  few.noise.ins_position_sigma_m = many.noise.ins_position_sigma_m = 0.05;
  few.partners = 4;
  many.partners = 12;
  const auto sigma_x = [](const testing::DriveOptions& options) {
    return std::sqrt(solve_joint(testing::simulate(options, 1).problem, options.noise, testing::mounting(), 20, {})
                         .covariance(0, 0));
  };
  EXPECT_GT(sigma_x(many) / sigma_x(few), 0.8) << sigma_x(few) << " m to " << sigma_x(many) << " m";
  const double mean = mean_normalised_error2(many, many.noise, 30);
  EXPECT_GT(mean, 4.0);
  EXPECT_LT(mean, 8.0);
}

TEST(joint_solver, finds_the_clock_offset) {
  const testing::DriveOptions options;
  constexpr double kOffset_s = 0.02;  // the poses were taken too early by this
  testing::SimulatedDrive drive = testing::simulate(options, 3);
  for (JointNode& node : drive.problem.nodes) {
    node.body_velocity = testing::true_velocity(options, node.time_s);
    node.local_from_ins = moved_in_body(node.local_from_ins, -kOffset_s * node.body_velocity);
  }
  drive.problem.session_attitude_bias_sigma_rad = {0.0};
  drive.problem.estimate_time_offset = true;
  const JointSolution solution = solve_joint(drive.problem, options.noise, kOff, 20, {});
  ASSERT_EQ(solution.time_offset_s.size(), 1U);
  EXPECT_NEAR(solution.time_offset_s[0], kOffset_s, 4.0 * solution.time_offset_sigma_s[0] + 2e-4);
  EXPECT_LT(solution.time_offset_sigma_s[0], 0.01);
}

// Registrations that three errors of the beams moved, each by what its surfaces make of them: with the way, and at
// random. Believed of unit variance.
testing::SimulatedDrive drive_with_beam_errors(const Eigen::Vector3d& errors, int seed) {
  testing::SimulatedDrive drive = testing::simulate({}, seed);
  std::mt19937_64 random(static_cast<std::uint64_t>(seed));
  for (JointTerm& term : drive.problem.terms) {
    const Eigen::Vector3d way_m = term.lidar_b_from_lidar_a.translation();
    term.beam_response.resize(6, 3);
    for (Eigen::Index i = 0; i < 3; ++i) term.beam_response.col(i) = 1e-3 * testing::random_step(random, 0.1, 0.01);
    term.beam_response(4, 0) += 5e-5 * way_m.x();
    term.beam_response.col(2).head<3>() += 2e-3 * way_m;
    term.lidar_b_from_lidar_a = perturb(term.lidar_b_from_lidar_a, -term.beam_response * errors);
  }
  return drive;
}

void solve_for_beams(JointProblem& problem, Eigen::Index of_single) {
  problem.lidar().beams.basis = Eigen::MatrixXd::Identity(3, 3);
  problem.lidar().beams.of_single = of_single;
}

TEST(joint_solver, errors_of_the_beams_are_found_and_x_errs_as_its_covariance_says) {
  constexpr int kDrives = 40;
  double of_x = 0.0, of_beams = 0.0, of_x_without = 0.0;
  for (int seed = 1; seed <= kDrives; ++seed) {
    std::mt19937_64 random(static_cast<std::uint64_t>(1000 + seed));
    std::normal_distribution<double> normal;
    const Eigen::Vector3d errors(normal(random), normal(random), normal(random));
    testing::SimulatedDrive drive = drive_with_beam_errors(errors, seed);
    of_x_without +=
        normalised_error2(solve_joint(drive.problem, NoiseModel{}, kOff, 20, {}), drive.ins_from_lidar) / kDrives;
    solve_for_beams(drive.problem, 0);
    const JointSolution solution = solve_joint(drive.problem, NoiseModel{}, kOff, 20, {});
    EXPECT_TRUE(solution.converged) << "seed " << seed;
    of_x += normalised_error2(solution, drive.ins_from_lidar) / kDrives;
    const Eigen::Vector3d off = solution.beams - errors;
    of_beams += testing::squared_over_sigma(off, solution.beams_covariance) / kDrives;
  }
  std::printf("  X: %.2f of 6, without the unknowns %.1f; beams: %.2f of 3\n", of_x, of_x_without, of_beams);
  EXPECT_GT(of_x, 4.4);
  EXPECT_LT(of_x, 7.8);
  EXPECT_GT(of_beams, 1.8);
  EXPECT_LT(of_beams, 4.4);
  EXPECT_GT(of_x_without, 1.5 * of_x);
}

// docs/maths/beams.md (B6)
TEST(joint_solver, of_single_beams_a_drive_tells_a_ninth) {
  testing::SimulatedDrive drive = drive_with_beam_errors({0.5, -0.5, 0.5}, 7);
  solve_for_beams(drive.problem, 0);
  const JointSolution whole = solve_joint(drive.problem, NoiseModel{}, kOff, 30, {});
  solve_for_beams(drive.problem, 3);
  const JointSolution single = solve_joint(drive.problem, NoiseModel{}, kOff, 30, {});
  ASSERT_TRUE(whole.converged && single.converged);
  const auto told = [](const JointSolution& solution) -> Eigen::Matrix3d {
    return solution.beams_covariance.inverse() - Eigen::Matrix3d::Identity();
  };
  EXPECT_LT((9.0 * told(single) - told(whole)).norm(), 0.05 * told(whole).norm()) << told(single) << "\n"
                                                                                  << told(whole);
  for (int i = 0; i < 6; ++i) EXPECT_GE(single.covariance(i, i), whole.covariance(i, i) * (1.0 - 1e-6)) << i;
}

TEST(joint_solver, a_measured_height_is_kept_in_full_beside_single_beams) {
  testing::SimulatedDrive drive = drive_with_beam_errors({0.5, -0.5, 0.5}, 9);
  solve_for_beams(drive.problem, 3);
  constexpr double kSigma_m = 1e-4;
  MeasuredOptions options;
  options.z_m = drive.ins_from_lidar.translation().z(), options.z_sigma_m = kSigma_m;
  drive.problem.lidar().measured = Measured(options, {});
  const JointSolution solution = solve_joint(drive.problem, NoiseModel{}, kOff, 30, {});
  ASSERT_TRUE(solution.converged);
  EXPECT_LT(std::sqrt(solution.covariance(2, 2)), 1.01 * kSigma_m);
  EXPECT_GT(symmetric_eigen(solution.information).eigenvalues().minCoeff(), -1e-6 * solution.information.norm());
}

TEST(joint_solver, terms_of_weight_zero_are_left_out) {
  const testing::DriveOptions options;
  testing::SimulatedDrive drive = testing::simulate(options, 4);
  const JointSolution without = solve_joint(drive.problem, options.noise, kOff, 20, {});
  JointTerm wrong = drive.problem.terms.front();
  wrong.lidar_b_from_lidar_a.translation().x() += 5.0;
  wrong.weight = 0.0;
  drive.problem.terms.push_back(wrong);
  const JointSolution with = solve_joint(drive.problem, options.noise, kOff, 20, {});
  EXPECT_LT(testing::distance_of(with.ins_from_lidar, without.ins_from_lidar), 1e-12);
}

TEST(joint_solver, what_flat_driving_does_not_show_stays_at_the_prior_with_its_sigma) {
  testing::DriveOptions options;
  options.tilt_rad = 0.0;
  options.noise = testing::no_noise();
  testing::SimulatedDrive drive = testing::simulate(options, 5);
  drive.problem.lidar().prior_ins_from_lidar.translation().z() = 0.7;
  drive.problem.lidar().prior_information = 4.0 * Matrix6d::Identity();
  const JointSolution solution = solve_joint(drive.problem, NoiseModel{}, kOff, 20, {});
  EXPECT_NEAR(solution.ins_from_lidar.translation().z(), 0.7, 1e-6);
  EXPECT_NEAR(std::sqrt(solution.covariance(2, 2)), 0.5, 1e-3);
  EXPECT_LT(std::abs(solution.information(2, 2)), 1e-3 * solution.information(0, 0)) << "the data say nothing";
}

TEST(joint_solver, cancelled_is_not_converged) {
  std::stop_source stop;
  stop.request_stop();
  const JointSolution solution =
      solve_joint(testing::simulate({}, 1).problem, NoiseModel{}, kOff, 20, Progress(stop.get_token()));
  EXPECT_FALSE(solution.converged);
  EXPECT_EQ(testing::distance_of(solution.ins_from_lidar, kOff), 0.0);
}

TEST(estimate_noise, recovers_the_sigmas_of_the_ins_within_thirty_percent_from_a_guess_three_times_off) {
  testing::DriveOptions options;
  options.keyframes = 80;
  options.noise.ins_position_sigma_m = 0.03;
  options.noise.ins_attitude_sigma_rad = 1e-3;
  const testing::SimulatedDrive drive = testing::simulate(options, 6);
  for (const double factor : {1.0 / 3.0, 3.0}) {
    NoiseModel guess = options.noise;
    guess.ins_position_sigma_m *= factor;
    guess.ins_attitude_sigma_rad *= factor;
    const NoiseModel found =
        estimate_noise(drive.problem, guess, {1.5, 1.5, 0, 0, 0, 0, 0}, drive.ins_from_lidar, {}, {});
    EXPECT_NEAR(found.ins_position_sigma_m / 0.03, 1.0, 0.3) << "from " << factor;
    EXPECT_NEAR(found.ins_attitude_sigma_rad / 1e-3, 1.0, 0.3) << "from " << factor;
    const NoiseModel again =
        estimate_noise(drive.problem, guess, {1.5, 1.5, 0, 0, 0, 0, 0}, drive.ins_from_lidar, found, {});
    EXPECT_NEAR(again.ins_position_sigma_m / found.ins_position_sigma_m, 1.0, 0.1) << "started where it ended";
    EXPECT_NEAR(again.ins_attitude_sigma_rad / found.ins_attitude_sigma_rad, 1.0, 0.1);
    EXPECT_EQ(found.registration_scale, guess.registration_scale) << "a spread of 0 holds it";
    EXPECT_EQ(found.ins_position_drift, 0.0) << "a component that is zero stays zero";
  }
}

}  // namespace
}  // namespace remount::calibration
