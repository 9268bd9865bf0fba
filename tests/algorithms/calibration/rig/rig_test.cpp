#include "algorithms/calibration/rig/rig.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iostream>

#include "algorithms/calibration/rig/rig_problem.h"
#include "messages/calibration.h"
#include "tests/algorithms/calibration/rig/rig_drives.h"
#include "tests/support/draws.h"

namespace remount::calibration {
namespace {

TEST(rig, exact_data_give_exact_mountings) {
  testing::RigOptions options = small_rig();
  options.drive.noise = testing::no_noise();
  options.drive.attitude_bias_sigma_rad = 0.0;
  testing::SimulatedRig rig = testing::simulate_rig(options, 1);
  const RigSolution solution = solve_rig(rig.lidars, rig.cross_pairs, {});
  ASSERT_TRUE(solution.solved);
  for (std::size_t l = 0; l < 3; ++l) {
    const Vector6d off = difference(options.ins_from_lidars[l], solution.ins_from_lidars[l]);
    EXPECT_LT(off.norm(), 1e-6) << off.transpose();
  }
  for (const CrossPair& cross : rig.cross_pairs) EXPECT_EQ(cross.pair.state, motion::PairState::Accepted);
  ASSERT_EQ(solution.groups.size(), 1u);
  EXPECT_EQ(solution.groups[0].size(), 3u);
}

void expect_sigmas_that_hold(double clock_sigma_s) {
  Tally single, relative;
  double narrower = 0.0;
  const int kDrives = testing::some_of_many(30, 16);
  for (int seed = 1; seed <= kDrives; ++seed) {
    testing::RigOptions options = small_rig();
    options.clock_sigma_s = clock_sigma_s;
    // In half of the drives two of the LiDARs look at the same time.
    if (seed % 2 == 0) options.phases_s[2] = options.phases_s[0];
    testing::SimulatedRig rig = testing::simulate_rig(options, seed);
    const RigSolution solution = solve_rig(rig.lidars, rig.cross_pairs, {});
    ASSERT_TRUE(solution.solved);
    for (std::size_t l = 0; l < 3; ++l)
      single.add(difference(options.ins_from_lidars[l], solution.ins_from_lidars[l]),
                 solution.covariance.diagonal().segment<6>(signed_of(6 * l)));
    for (const RelativeMounting& two : solution.relatives) {
      const Eigen::Matrix<double, 6, 12> jacobian =
          relative_jacobian(solution.ins_from_lidars[two.lidar_a], solution.ins_from_lidars[two.lidar_b]);
      Eigen::Matrix<double, 12, 12> covariance;
      const Eigen::Index a = signed_of(6 * two.lidar_a), b = signed_of(6 * two.lidar_b);
      covariance << solution.covariance.block<6, 6>(a, a), solution.covariance.block<6, 6>(a, b),
          solution.covariance.block<6, 6>(b, a), solution.covariance.block<6, 6>(b, b);
      const RigidTransform truth =
          relative_mounting(options.ins_from_lidars[two.lidar_a], options.ins_from_lidars[two.lidar_b]);
      relative.add(difference(truth, two.lidar_a_from_lidar_b),
                   (jacobian * covariance * jacobian.transpose()).diagonal());
      narrower += (two.height_sigma_m < std::sqrt(solution.covariance(a + 2, a + 2))) / (3.0 * kDrives);
    }
  }
  single.expect_within_one_percent("mountings", kDrives);
  relative.expect_within_one_percent("relative mountings", kDrives);
  EXPECT_GT(narrower, 0.9) << "share of relative heights that are known better than the heights";
}

TEST(rig, sigmas_of_mountings_and_between_them_hold) { expect_sigmas_that_hold(0.0); }

TEST(rig, so_they_do_where_the_clock_of_each_lidar_is_unknown) { expect_sigmas_that_hold(2e-3); }

// Stamps are the same, but one is measured before them and the other behind.
TEST(rig, equal_stamps_are_not_at_once_where_sweeps_lie_end_to_end) {
  RigLidar before, behind;
  before.at_once_s = behind.at_once_s = 1e-3;
  const motion::Sweep ends{-0.1, 0.0}, begins{0.0, 0.1}, gathered{-0.1, 0.2};
  EXPECT_FALSE(is_at_once(before, ends, behind, begins, 0.0));
  EXPECT_FALSE(is_at_once(before, gathered, behind, begins, 0.0));
  EXPECT_TRUE(is_at_once(before, begins, behind, begins, 5e-4));
  EXPECT_TRUE(is_at_once(before, {}, behind, {}, 5e-4));
  EXPECT_FALSE(is_at_once(before, {}, behind, {}, 2e-3));
  EXPECT_EQ(common_share(ends, begins, 0.0), 0.0);
  EXPECT_NEAR(common_share(gathered, begins, 0.0), 1.0 / std::sqrt(3.0), 1e-12);
  EXPECT_NEAR(common_share(begins, begins, 0.03), 0.7, 1e-12);
}

TEST(rig, flat_driving_tells_heights_against_each_other_alone) {
  testing::RigOptions options = small_rig();
  options.drive.tilt_rad = 0.0;
  testing::SimulatedRig rig = testing::simulate_rig(options, 3);
  const RigSolution solution = solve_rig(rig.lidars, rig.cross_pairs, {});
  ASSERT_TRUE(solution.solved);
  double above_given_m = 0.0;
  for (std::size_t l = 0; l < 3; ++l) {
    EXPECT_FALSE(solution.results[l].observed().contains(Parameter::Z));
    above_given_m +=
        solution.results[l].estimate(Parameter::Z).value - rig.lidars[l].alone.estimate(Parameter::Z).value;
  }
  EXPECT_NEAR(above_given_m, 0.0, 1e-9) << "of three LiDARs together";
  for (const RelativeMounting& two : solution.relatives) {
    const double truth =
        options.ins_from_lidars[two.lidar_b].translation().z() - options.ins_from_lidars[two.lidar_a].translation().z();
    EXPECT_LT(two.height_sigma_m, 5e-3);
    EXPECT_NEAR(two.height_m, truth, 4.0 * two.height_sigma_m);
  }
}

TEST(rig, what_one_lidar_was_told_serves_all) {
  testing::RigOptions options = small_rig();
  options.drive.tilt_rad = 0.0;
  testing::SimulatedRig rig = testing::simulate_rig(options, 4);
  MeasuredOptions tape;
  tape.z_m = options.ins_from_lidars[1].translation().z();
  tape.z_sigma_m = 0.005;
  rig.lidars[1].input.measured = Measured(tape, {});
  rig.lidars[1].alone = solve_pairwise(rig.lidars[1].input, rig.lidars[1].pairs, rig.lidars[1].details, {});
  const RigSolution solution = solve_rig(rig.lidars, rig.cross_pairs, {});
  ASSERT_TRUE(solution.solved);
  for (std::size_t l = 0; l < 3; ++l) {
    const Estimate z = solution.results[l].estimate(Parameter::Z);
    ASSERT_TRUE(z.observed) << l;
    EXPECT_LT(*z.sigma, 0.012) << l;
    EXPECT_NEAR(z.value, options.ins_from_lidars[l].translation().z(), 4.0 * *z.sigma) << l;
    EXPECT_TRUE(z.measured) << l;
    EXPECT_FALSE(solution.results[l].estimate(Parameter::X).measured);
    for (const Message& advice : solution.results[l].advice)
      EXPECT_NE(advice, say::need_pitch_or_roll()) << "the height of " << l << " is known";
  }
}

// The value and the drive contradict each other: the LiDAR's own result says so by its sigma, and so do the others'.
TEST(rig, a_measured_value_that_is_doubted_is_doubted_for_all) {
  testing::RigOptions options = small_rig();
  testing::SimulatedRig rig = testing::simulate_rig(options, 4);
  MeasuredOptions tape;
  tape.z_m = options.ins_from_lidars[1].translation().z() + 1.0;
  tape.z_sigma_m = 0.005;
  rig.lidars[1].input.measured = Measured(tape, {});
  rig.lidars[1].alone = solve_pairwise(rig.lidars[1].input, rig.lidars[1].pairs, rig.lidars[1].details, {});
  std::cout << "alone: z " << rig.lidars[1].alone.mounting.ins_from_lidar().translation().z() << " m, sigma "
            << std::sqrt(rig.lidars[1].alone.covariance(2, 2)) << " m\n";
  const RigSolution solution = solve_rig(rig.lidars, rig.cross_pairs, {});
  ASSERT_TRUE(solution.solved);
  for (std::size_t l = 0; l < 3; ++l) {
    const Eigen::Index z = signed_of(6 * l + 2);
    const double sigma_m = std::sqrt(solution.covariance(z, z)),
                 off_m = solution.ins_from_lidars[l].translation().z() - options.ins_from_lidars[l].translation().z();
    std::cout << "z of " << l << " off by " << off_m << " m, sigma " << sigma_m << " m\n";
    EXPECT_LT(std::abs(off_m), 2.0 * sigma_m) << l;
  }
}

// The attitude of the INS is off by the same for all; what one LiDAR's own calibration doubts beside that tells nothing
// of it.
TEST(rig, doubts_of_lidars_do_not_measure_the_bias_of_the_ins) {
  testing::RigOptions options = small_rig();
  options.drive.attitude_bias_sigma_rad = degrees_to_radians(0.2);
  for (const auto& factors : {std::array{2.0, 1.0, 1.0}, std::array{2.0, 4.0, 3.0}}) {
    testing::SimulatedRig rig = testing::simulate_rig(options, 9);
    for (std::size_t l = 0; l < 3; ++l) {
      rig.lidars[l].details.pairs_covariance *= factors[l];
      rig.lidars[l].alone.covariance *= factors[l];
    }
    const RigSolution solution = solve_rig(rig.lidars, rig.cross_pairs, {});
    ASSERT_TRUE(solution.solved);
    const double least_rad =
        options.drive.attitude_bias_sigma_rad * std::sqrt(*std::min_element(factors.begin(), factors.end()));
    for (std::size_t l = 0; l < 3; ++l)
      for (int axis = 3; axis < 6; ++axis) {
        const Eigen::Index at = signed_of(6 * l) + axis;
        EXPECT_GT(std::sqrt(solution.covariance(at, at)), 0.97 * least_rad) << l << " about axis " << axis - 3;
      }
    for (const RelativeMounting& two : solution.relatives)
      for (int axis = 3; axis < 6; ++axis) EXPECT_LT(std::sqrt(two.covariance(axis, axis)), 0.2 * least_rad);
  }
}

// On flat ground, where no height is known, and whatever the order of the LiDARs is.
TEST(rig, doubts_are_the_same_in_any_order_and_on_flat_ground) {
  testing::RigOptions options = small_rig();
  options.drive.attitude_bias_sigma_rad = degrees_to_radians(0.2);
  for (const double tilt_rad : {0.0, options.drive.tilt_rad}) {
    options.drive.tilt_rad = tilt_rad;
    const auto solved_in = [&](const std::array<std::size_t, 3>& order) {
      testing::SimulatedRig rig = testing::simulate_rig(options, 11);
      constexpr std::array kFactors{2.0, 4.0, 3.0};
      for (std::size_t l = 0; l < 3; ++l) rig.lidars[l].details.pairs_covariance *= kFactors[l];
      std::vector<RigLidar> lidars;
      std::array<motion::LidarIndex, 3> place_of;
      for (std::size_t l = 0; l < 3; ++l) {
        lidars.push_back(rig.lidars[order[l]]);
        place_of[order[l]] = motion::LidarIndex(l);
      }
      for (CrossPair& cross : rig.cross_pairs) {
        cross.lidar_a = place_of[cross.lidar_a];
        cross.lidar_b = place_of[cross.lidar_b];
      }
      const RigSolution solution = solve_rig(lidars, rig.cross_pairs, {});
      std::vector<Vector6d> sigmas(3);
      for (std::size_t l = 0; l < 3 && solution.solved; ++l)
        sigmas[order[l]] = solution.covariance.diagonal().segment<6>(signed_of(6 * l)).cwiseSqrt();
      return sigmas;
    };
    const std::vector<Vector6d> sigmas = solved_in({0, 1, 2}), others = solved_in({2, 0, 1});
    for (std::size_t l = 0; l < 3; ++l) {
      EXPECT_LT((sigmas[l] - others[l]).cwiseQuotient(sigmas[l]).cwiseAbs().maxCoeff(), 0.02)
          << l << ": " << sigmas[l].transpose() << " and " << others[l].transpose();
      EXPECT_GT(sigmas[l].tail<3>().minCoeff(), 0.97 * std::sqrt(2.0) * options.drive.attitude_bias_sigma_rad) << l;
    }
  }
}

TEST(rig, cross_pairs_that_are_wrong_are_rejected_with_the_reason) {
  testing::RigOptions options = small_rig();
  testing::SimulatedRig rig = testing::simulate_rig(options, 5);
  for (std::size_t i = 0; i < rig.cross_pairs.size(); i += 4) {
    RigidTransform& motion = rig.cross_pairs[i].pair.lidar_b_from_lidar_a;
    motion.translation().x() += i % 8 == 0 ? 0.4 : -0.2;
  }
  const RigSolution solution = solve_rig(rig.lidars, rig.cross_pairs, {});
  ASSERT_TRUE(solution.solved);
  int right = 0;
  for (std::size_t i = 0; i < rig.cross_pairs.size(); ++i) {
    const motion::Pair& pair = rig.cross_pairs[i].pair;
    if (i % 4 == 0) {
      EXPECT_EQ(pair.state, motion::PairState::Rejected) << i;
      EXPECT_FALSE(pair.reason.empty()) << i;
    }
    right += i % 4 != 0 && pair.state == motion::PairState::Accepted;
  }
  EXPECT_GT(right, 0.95 * 0.75 * static_cast<double>(rig.cross_pairs.size()));
  for (std::size_t l = 0; l < 3; ++l)
    EXPECT_LT(difference(options.ins_from_lidars[l], solution.ins_from_lidars[l]).head<2>().norm(), 0.02);
}

TEST(rig, lidars_that_contradict_the_ins_are_told) {
  const testing::RigOptions options = small_rig();
  testing::SimulatedRig rig = testing::simulate_rig(options, 6);
  const RigSolution sound = solve_rig(rig.lidars, rig.cross_pairs, {});
  ASSERT_TRUE(sound.solved);
  ASSERT_EQ(sound.agreements.size(), 3u);
  for (const RigAgreement& two : sound.agreements) EXPECT_LT(two.most_sigmas, 4.0);
  // What the third LiDAR sees of others is turned by 0.3 degrees against what it sees of itself.
  Vector6d turned = Vector6d::Zero();
  turned[5] = degrees_to_radians(0.3);
  for (CrossPair& cross : rig.cross_pairs)
    if (cross.lidar_b == motion::LidarIndex{2})
      cross.pair.lidar_b_from_lidar_a = perturb(cross.pair.lidar_b_from_lidar_a, turned);
  const RigSolution solution = solve_rig(rig.lidars, rig.cross_pairs, {});
  ASSERT_TRUE(solution.solved);
  for (const RigAgreement& two : solution.agreements)
    EXPECT_EQ(two.most_sigmas > 3.5, two.lidar_b == motion::LidarIndex{2})
        << two.lidar_a << " and " << two.lidar_b << ": " << two.most_sigmas << " sigma";
}

TEST(rig, without_cross_pairs_the_ins_joins_them) {
  testing::RigOptions options = small_rig();
  options.any_cross = false;
  testing::SimulatedRig rig = testing::simulate_rig(options, 7);
  const RigSolution solution = solve_rig(rig.lidars, rig.cross_pairs, {});
  ASSERT_TRUE(solution.solved);
  EXPECT_EQ(solution.groups.size(), 3u);
  for (std::size_t l = 0; l < 3; ++l)
    for (const Parameter parameter : kParameters) {
      const Estimate together = solution.results[l].estimate(parameter),
                     alone = rig.lidars[l].alone.estimate(parameter);
      ASSERT_TRUE(together.observed && alone.observed);
      EXPECT_NEAR(together.value, alone.value, 2.0 * *alone.sigma);
      EXPECT_LT(*together.sigma, 1.25 * *alone.sigma);
      EXPECT_GT(*together.sigma, 0.4 * *alone.sigma);
    }
}

TEST(rig, is_not_solved_where_cancelled) {
  testing::SimulatedRig rig = testing::simulate_rig(small_rig(), 8);
  std::stop_source stop;
  stop.request_stop();
  EXPECT_FALSE(solve_rig(rig.lidars, rig.cross_pairs, Progress(stop.get_token())).solved);
}

}  // namespace
}  // namespace remount::calibration
