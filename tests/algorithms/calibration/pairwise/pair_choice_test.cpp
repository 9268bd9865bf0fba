#include "algorithms/calibration/pairwise/pair_choice.h"

#include <gtest/gtest.h>

#include <cstdio>
#include <random>
#include <set>

#include "algorithms/calibration/joint/pair_equation.h"
#include "algorithms/calibration/observability.h"
#include "algorithms/calibration/pairwise/noise_prior.h"
#include "algorithms/core/symmetric_eigen.h"

namespace remount::calibration {
namespace {

const SixParameters kChosenFor{1.2, -0.3, 1.6, 0.03, -0.02, 0.015};

// Straight on for 100 s, then a minute of turns on hills; keyframes every 0.5 s, each with the eight after it.
struct LongDrive {
  PairwiseInput input;
  std::vector<motion::Pair> pairs;
  NoiseModel noise;
  RigidTransform x = rigid_from_six(kChosenFor);
};

constexpr int kKeyframes = 320, kFirstTurning = 200;

RigidTransform pose_at(int k) {
  const double turning = std::max(0, k - kFirstTurning);
  return rigid_from_six({2.0 * k, 5.0 * std::sin(0.1 * turning), 0.2 * std::sin(0.3 * turning),
                         0.9 * std::sin(0.1 * turning), 0.05 * std::sin(0.23 * turning),
                         0.05 * std::sin(0.31 * turning)});
}

LongDrive long_drive() {
  LongDrive drive;
  drive.input.sessions.resize(1);
  for (int k = 0; k < kKeyframes; ++k) {
    JointNode node;
    node.time_s = 0.5 * k;
    node.local_from_ins = pose_at(k);
    drive.input.nodes.push_back(node);
  }
  for (int a = 0; a < kKeyframes; ++a)
    for (int b = a + 1; b < std::min(kKeyframes, a + 9); ++b) {
      motion::Pair pair;
      pair.keyframe_a = index_at<motion::KeyframeIndex>(a);
      pair.keyframe_b = index_at<motion::KeyframeIndex>(b);
      pair.ins_b_from_ins_a = pose_at(b).inverse() * pose_at(a);
      pair.baseline_m = pair.ins_b_from_ins_a.translation().norm();
      pair.rotation_rad = so3_log(pair.ins_b_from_ins_a.linear()).norm();
      drive.pairs.push_back(pair);
    }
  expect_registrations(drive.x, drive.pairs);
  drive.noise = noise_prior(drive.input).expected;
  return drive;
}

double log_determinant_of(const LongDrive& drive, const std::vector<bool>& taken) {
  std::vector<double> weights(taken.begin(), taken.end());
  const Matrix6d information =
      expected_information(drive.input, drive.pairs, weights, drive.noise, drive.x, Progress()) + weak_prior(true);
  return symmetric_eigen(information).eigenvalues().array().log().sum();
}

PairChooser chooser_of(const LongDrive& drive) {
  return {drive.input, drive.pairs, drive.noise, drive.x, std::vector<bool>(drive.pairs.size(), false)};
}

TEST(pair_choice, takes_as_many_as_asked_for_and_in_the_end_all) {
  const LongDrive drive = long_drive();
  PairChooser chooser = chooser_of(drive);
  chooser.take(100);
  EXPECT_EQ(chooser.taken_count(), 100U);
  EXPECT_EQ(std::count(chooser.taken().begin(), chooser.taken().end(), true), 100);
  const std::vector<bool> before = chooser.taken();
  chooser.take(100);
  EXPECT_EQ(chooser.taken_count(), 200U);
  for (std::size_t i = 0; i < before.size(); ++i) EXPECT_TRUE(!before[i] || chooser.taken()[i]) << i;
  chooser.take(1'000'000);
  EXPECT_EQ(chooser.taken_count(), drive.pairs.size());
}

// Registrations, and scans that are prepared for them.
double work_of(const LongDrive& drive, const std::vector<bool>& taken) {
  std::set<std::size_t> scans;
  double registrations = 0.0;
  for (std::size_t i = 0; i < drive.pairs.size(); ++i) {
    if (!taken[i]) continue;
    scans.insert({std::size_t{drive.pairs[i].keyframe_a}, std::size_t{drive.pairs[i].keyframe_b}});
    registrations += 1.0;
  }
  return registrations + 1.5 * static_cast<double>(scans.size());
}

TEST(pair_choice, tells_more_than_pairs_that_are_spread_evenly_for_the_same_work) {
  const LongDrive drive = long_drive();
  std::vector<bool> even(drive.pairs.size(), false);
  for (std::size_t i = 0; i < 150; ++i) even[i * drive.pairs.size() / 150] = true;
  PairChooser chooser = chooser_of(drive);
  while (work_of(drive, chooser.taken()) < work_of(drive, even)) chooser.take(5);
  const double chosen = log_determinant_of(drive, chooser.taken()), spread = log_determinant_of(drive, even);
  std::printf("  log of the determinant: %.2f by %zu chosen, %.2f by 150 spread evenly\n", chosen,
              chooser.taken_count(), spread);
  EXPECT_GT(chosen, spread + 0.5);
}

TEST(pair_choice, favours_turns_and_leaves_no_time_out) {
  const LongDrive drive = long_drive();
  PairChooser chooser = chooser_of(drive);
  chooser.take(300);
  std::set<int> stretches;
  std::size_t turning = 0;
  for (std::size_t i = 0; i < drive.pairs.size(); ++i) {
    if (!chooser.taken()[i]) continue;
    stretches.insert(static_cast<int>(drive.input.nodes[drive.pairs[i].keyframe_a].time_s / 10.0));
    turning += drive.pairs[i].keyframe_a >= static_cast<std::size_t>(kFirstTurning);
  }
  std::printf("  %zu of 300 of the turns, %zu of 16 stretches\n", turning, stretches.size());
  EXPECT_GT(turning, 150U) << "they are 3 of 8 of all";
  EXPECT_GE(stretches.size(), 15U);
}

TEST(pair_choice, expects_of_all_pairs_what_the_joint_solution_says_of_them_once_registered) {
  LongDrive drive = long_drive();
  std::mt19937 random(5);
  std::normal_distribution<double> noise;
  for (motion::Pair& pair : drive.pairs) {
    pair.registration.attempted = pair.registration.converged = true;
    const auto step = [&](double sigma) { return sigma * noise(random); };
    Vector6d error;
    error << step(3e-3), step(3e-3), step(3e-3), step(2.5e-4), step(2.5e-4), step(2.5e-4);
    pair.lidar_b_from_lidar_a = perturb(pair.lidar_b_from_lidar_a, error);
  }
  drive.input.nominal_ins_from_lidar = drive.x;
  PairwiseDetails details;
  std::vector<motion::Pair> solved = drive.pairs;
  const CalibrationResult result = solve_pairwise(drive.input, solved, details, Progress());
  ASSERT_EQ(result.status, Status::Ok);
  std::vector<double> weights;
  for (const motion::Pair& pair : solved) weights.push_back(pair.weight);
  for (motion::Pair& pair : solved) pair.registration.attempted = false;
  expect_registrations(drive.x, solved);
  for (std::size_t i = 0; i < solved.size(); ++i)
    solved[i].registration.information = drive.pairs[i].registration.information;
  const Matrix6d expected =
      expected_information(drive.input, solved, weights, details.noise, details.joint.ins_from_lidar, Progress());
  for (int i = 0; i < 6; ++i) {
    const double ratio = std::sqrt(expected(i, i) / details.joint.information(i, i));
    std::printf("  %d: %.3f\n", i, ratio);
    EXPECT_NEAR(ratio, 1.0, 0.05) << i;
  }
}

TEST(pair_choice, expects_of_a_pair_what_one_near_it_of_the_same_length_told) {
  LongDrive drive = long_drive();
  // Long ways show less of turns; one in nine is registered.
  for (std::size_t i = 0; i < drive.pairs.size(); i += 9) {
    motion::Pair& pair = drive.pairs[i];
    pair.registration.attempted = true;
    pair.state = motion::PairState::Accepted;
    pair.registration.information.diagonal().tail<3>().setConstant(1e6 / (pair.baseline_m * pair.baseline_m));
  }
  drive.pairs[5].registration.attempted = true;  // one that failed tells nothing of others
  drive.pairs[5].state = motion::PairState::Rejected;
  drive.pairs[5].registration.information.setZero();
  expect_registrations(drive.x, drive.pairs);
  for (std::size_t i = 0; i < drive.pairs.size(); ++i) {
    if (i == 5) continue;
    const double told = std::sqrt(1e6 / drive.pairs[i].registration.information(5, 5));
    EXPECT_NEAR(told, drive.pairs[i].baseline_m, 1.0) << i;
  }
}

}  // namespace
}  // namespace remount::calibration
