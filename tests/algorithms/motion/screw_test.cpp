#include "algorithms/motion/screw.h"

#include <gtest/gtest.h>

#include "tests/algorithms/support/random_motion.h"

namespace remount::motion {
namespace {

constexpr double kRotationSigma_rad = 5e-4, kTranslationSigma_m = 0.01, kThreshold = 5.0;

ScrewTest test(const search::MotionPair& pair) {
  return screw_test(pair.ins_b_from_ins_a, pair.lidar_b_from_lidar_a, kRotationSigma_rad, kTranslationSigma_m,
                    kThreshold);
}

TEST(screw, invariants_of_an_exact_pair_are_zero_whatever_the_mounting) {
  std::mt19937_64 random(1);
  for (int mounting = 0; mounting < 50; ++mounting)
    for (const search::MotionPair& pair : testing::exact_pairs(random, testing::random_rigid(random, 2.0), 10)) {
      const ScrewTest result = test(pair);
      EXPECT_NEAR(result.rotation_difference_rad, 0.0, 1e-12);
      EXPECT_NEAR(result.translation_difference_m, 0.0, 1e-11);
      EXPECT_TRUE(result.passed);
      EXPECT_LT(result.score, 1e-8);
    }
}

TEST(screw, a_wrong_turn_is_flagged_with_its_size) {
  std::mt19937_64 random(2);
  for (search::MotionPair pair : testing::exact_pairs(random, testing::random_rigid(random, 2.0), 20, {0, 0, 1})) {
    const Eigen::Vector3d turn = so3_log(pair.lidar_b_from_lidar_a.linear());
    pair.lidar_b_from_lidar_a.linear() = so3_exp(turn * (1.0 + 0.02 / turn.norm()));
    const ScrewTest result = test(pair);
    EXPECT_NEAR(result.rotation_difference_rad, -0.02, 1e-9);
    EXPECT_FALSE(result.passed) << result.score;
  }
}

TEST(screw, a_wrong_shift_along_the_axis_is_flagged_and_one_across_it_cannot_be) {
  std::mt19937_64 random(3);
  const search::MotionPair exact =
      testing::exact_pair(make_rigid(so3_exp({0, 0, 0.4}), {3, 1, 0}), testing::random_rigid(random, 1.0));
  const Eigen::Vector3d axis = so3_log(exact.lidar_b_from_lidar_a.linear()).normalized();
  search::MotionPair along = exact, across = exact;
  along.lidar_b_from_lidar_a.translation() += 0.5 * axis;
  across.lidar_b_from_lidar_a.translation() += 0.5 * axis.unitOrthogonal();
  EXPECT_FALSE(test(along).passed) << test(along).score;
  EXPECT_NEAR(test(along).translation_difference_m, -0.5, 1e-12);
  EXPECT_TRUE(test(across).passed) << test(across).score;
}

TEST(screw, without_a_turn_there_is_no_axis_to_judge_by) {
  search::MotionPair straight;
  straight.ins_b_from_ins_a.translation() = Eigen::Vector3d(5, 0, 0);
  straight.lidar_b_from_lidar_a.translation() = Eigen::Vector3d(0, 0, 5);
  EXPECT_TRUE(test(straight).passed);
  EXPECT_EQ(test(straight).translation_difference_m, 0.0);
}

}  // namespace
}  // namespace remount::motion
