#include "algorithms/search/candidates.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "algorithms/messages/render.h"
#include "tests/algorithms/support/random_motion.h"

namespace remount::search {
namespace {

constexpr double kMinRotation_rad = 0.01, kMinAxisAngle_rad = 0.09;

double equation_error(const MotionPair& pair, const RigidTransform& x) { return frobenius_sum({pair}, x, 1.0); }

TEST(single_pair, satisfies_its_pair_and_no_member_of_the_family_is_nearer_to_the_nominal) {
  std::mt19937_64 random(1);
  for (int trial = 0; trial < 40; ++trial) {
    const RigidTransform truth = testing::random_rigid(random, 1.0),
                         nominal = perturb(truth, testing::random_step(random, 0.5, 0.3));
    const MotionPair pair = testing::exact_pairs(random, truth, 1).front();
    const RigidTransform x = single_pair_candidate(pair, nominal, kMinRotation_rad);
    EXPECT_LT(equation_error(pair, x), 1e-9);
    const Eigen::Vector3d axis = so3_log(pair.ins_b_from_ins_a.linear()).normalized();
    const double turn_rad = rotation_angle_between_rad(x, nominal);
    const double shift_m = (x.translation() - nominal.translation()).norm();
    for (double step = -3.0; step <= 3.0; step += 0.1) {
      const RigidTransform turned = make_rigid(so3_exp(step * axis) * x.linear(), x.translation());
      EXPECT_GE(rotation_angle_between_rad(turned, nominal), turn_rad - 1e-9);
      const RigidTransform shifted = make_rigid(x.linear(), x.translation() + step * axis);
      EXPECT_LT(equation_error(pair, shifted), 1e-9) << "the family's free translation";
      EXPECT_GE((shifted.translation() - nominal.translation()).norm(), shift_m - 1e-9);
    }
  }
}

TEST(single_pair, without_a_turn_the_direction_of_travel_is_used_and_the_translation_kept) {
  std::mt19937_64 random(2);
  const RigidTransform truth = testing::random_rigid(random, 1.0),
                       nominal = perturb(truth, testing::random_step(random, 0.5, 0.2));
  const MotionPair pair = testing::exact_pair(make_rigid(Eigen::Matrix3d::Identity(), {-6, 0.3, 0.1}), truth);
  const RigidTransform x = single_pair_candidate(pair, nominal, kMinRotation_rad);
  EXPECT_LT(equation_error(pair, x), 1e-9);
  EXPECT_EQ((x.translation() - nominal.translation()).norm(), 0.0);
  const MotionPair still = testing::exact_pair(RigidTransform::Identity(), truth);
  EXPECT_LT(testing::distance_of(single_pair_candidate(still, nominal, kMinRotation_rad), nominal), 1e-12);
}

TEST(two_pairs, are_exact_and_refused_for_parallel_axes_or_small_turns) {
  std::mt19937_64 random(3);
  int tested = 0;
  for (int trial = 0; trial < 40; ++trial) {
    const RigidTransform truth = testing::random_rigid(random, 1.0);
    const std::vector<MotionPair> pairs = testing::exact_pairs(random, truth, 2);
    const auto x =
        two_pair_candidate(pairs[0], pairs[1], RigidTransform::Identity(), kMinRotation_rad, kMinAxisAngle_rad);
    if (!x) continue;
    ++tested;
    EXPECT_LT(testing::distance_of(*x, truth), 1e-7);
    const std::vector<MotionPair> parallel = testing::exact_pairs(random, truth, 2, {0, 0, 1});
    EXPECT_FALSE(two_pair_candidate(parallel[0], parallel[1], truth, kMinRotation_rad, kMinAxisAngle_rad));
    EXPECT_FALSE(two_pair_candidate(pairs[0], pairs[1], truth, 4.0, kMinAxisAngle_rad));
  }
  EXPECT_GT(tested, 30);
}

TEST(all_pairs, closed_forms_are_exact_on_exact_data) {
  std::mt19937_64 random(4);
  for (int trial = 0; trial < 40; ++trial) {
    const RigidTransform truth = testing::random_rigid(random, 1.0);
    const std::vector<MotionPair> pairs = testing::exact_pairs(random, truth, 3 + trial);
    const auto by_logarithms = park_martin(pairs, RigidTransform::Identity());
    const auto by_dual_quaternions = dual_quaternion(pairs);
    ASSERT_TRUE(by_logarithms && by_dual_quaternions) << trial;
    EXPECT_LT(testing::distance_of(*by_logarithms, truth), 1e-8);
    EXPECT_LT(testing::distance_of(*by_dual_quaternions, truth), 1e-6);
  }
}

TEST(all_pairs, closed_forms_are_refused_where_all_axes_are_parallel) {
  std::mt19937_64 random(5);
  for (int trial = 0; trial < 200; ++trial) {
    const RigidTransform truth = testing::random_rigid(random, 1.0);
    const std::vector<MotionPair> pairs = testing::exact_pairs(random, truth, 2 + trial % 20, {0, 0, 1}, {1, 1, 0});
    EXPECT_FALSE(park_martin(pairs, truth)) << trial;
    EXPECT_FALSE(dual_quaternion(pairs)) << trial;
  }
  EXPECT_FALSE(park_martin({}, RigidTransform::Identity()));
  EXPECT_FALSE(dual_quaternion({}));
}

std::vector<Eigen::Matrix3d> hard_orientations() {
  std::vector<Eigen::Matrix3d> out;
  for (const double yaw_deg : {0.0, 90.0, 180.0, -135.0})
    for (const double pitch_deg : {0.0, 45.0, 89.9, 90.0, -90.0})
      for (const double roll_deg : {0.0, 180.0, 67.5})
        out.push_back(rotation_from_yaw_pitch_roll(
            {degrees_to_radians(yaw_deg), degrees_to_radians(pitch_deg), degrees_to_radians(roll_deg)}));
  return out;
}

TEST(joint_quadratic, is_exact_for_any_orientation) {
  std::mt19937_64 random(6);
  for (const Eigen::Matrix3d& rotation : hard_orientations()) {
    const RigidTransform truth = make_rigid(rotation, testing::random_vector(random, 1.0));
    const RigidTransform x = joint_quadratic(QuadraticForm(testing::exact_pairs(random, truth, 20), 10.0), {0, 0, 0});
    EXPECT_LT(testing::distance_of(x, truth), 1e-5)
        << six_from_rigid(truth).yaw_rad << " " << six_from_rigid(truth).pitch_rad;
  }
}

TEST(joint_quadratic, is_exact_for_planar_motion_except_for_the_height_that_stays_near) {
  std::mt19937_64 random(7);
  for (const Eigen::Matrix3d& rotation : hard_orientations()) {
    const RigidTransform truth = make_rigid(rotation, testing::random_vector(random, 1.0));
    const QuadraticForm form(testing::exact_pairs(random, truth, 20, {0, 0, 1}, {1, 1, 0}), 10.0);
    const RigidTransform x = joint_quadratic(form, {0.0, 0.0, 1.25});
    EXPECT_LT(rotation_angle_between_rad(x, truth), 1e-5);
    EXPECT_LT((x.translation() - truth.translation()).head<2>().norm(), 1e-5);
    EXPECT_NEAR(x.translation().z(), 1.25, 1e-6);
  }
}

TEST(ranking, the_certified_optimum_is_a_candidate_in_range_with_its_gap) {
  std::mt19937_64 random(9);
  const RigidTransform truth = make_rigid(so3_exp({0.1, -0.2, 0.3}), {1.0, 0.5, 1.5});
  std::vector<MotionPair> pairs = testing::exact_pairs(random, truth, 30);
  for (MotionPair& pair : pairs)
    pair.lidar_b_from_lidar_a = perturb(pair.lidar_b_from_lidar_a, testing::random_step(random, 0.01, 1e-3));
  calibration::SearchRange range;
  for (const double x_max_m : {5.0, 0.5}) {  // the truth inside, then outside
    range.x_max_m = x_max_m;
    const std::vector<calibration::Candidate> ranked =
        find_candidates(pairs, std::vector<motion::PairIndex>(pairs.size(), motion::PairIndex{1}),
                        RigidTransform::Identity(), range, {});
    const auto certified = std::find_if(ranked.begin(), ranked.end(), [](const calibration::Candidate& candidate) {
      return candidate.source == calibration::MountingSource::CertifiedOptimum;
    });
    ASSERT_NE(certified, ranked.end());
    EXPECT_TRUE(certified->in_range) << certified->out_of_range;
    EXPECT_GE(certified->certified_gap, 0.0);
    EXPECT_LE(certified->certified_gap, 1e-6);
    const QuadraticForm form(pairs, 1.0);
    for (const calibration::Candidate& other : ranked) {
      if (!other.in_range) continue;
      EXPECT_GE(form.value(other.ins_from_lidar), form.value(certified->ins_from_lidar) * (1.0 - 2e-6))
          << to_string(other.source);
    }
  }
}

TEST(ranking, in_range_first_then_by_error_and_the_truth_wins) {
  std::mt19937_64 random(8);
  const RigidTransform truth = make_rigid(so3_exp({0.1, -0.2, 0.3}), {1.0, 0.5, 1.5});
  const std::vector<MotionPair> pairs = testing::exact_pairs(random, truth, 10);
  std::vector<motion::PairIndex> names;
  for (int i = 0; i < 10; ++i) names.push_back(index_at<motion::PairIndex>(100 + i));
  calibration::SearchRange range;
  const std::vector<calibration::Candidate> ranked =
      find_candidates(pairs, names, RigidTransform::Identity(), range, {});
  ASSERT_GT(ranked.size(), 20U);
  EXPECT_LT(testing::distance_of(ranked.front().ins_from_lidar, truth), 1e-5) << to_string(ranked.front().source);
  const auto before = [](const calibration::Candidate& left, const calibration::Candidate& right) {
    return left.in_range != right.in_range ? left.in_range : left.frobenius_sum < right.frobenius_sum;
  };
  EXPECT_TRUE(std::is_sorted(ranked.begin(), ranked.end(), before));
  EXPECT_TRUE(std::any_of(ranked.begin(), ranked.end(), [](const calibration::Candidate& c) {
    return c.source == calibration::MountingSource::pair(motion::PairIndex{103});
  }));
  range.x_max_m = 0.5;  // now the truth is outside: kept, in words, after all that are inside
  const std::vector<calibration::Candidate> outside =
      find_candidates(pairs, names, RigidTransform::Identity(), range, {});
  EXPECT_EQ(outside.size(), ranked.size());
  EXPECT_TRUE(std::is_sorted(outside.begin(), outside.end(), before));
  EXPECT_FALSE(outside.back().in_range);
  EXPECT_FALSE(outside.back().out_of_range.empty());
}

}  // namespace
}  // namespace remount::search
