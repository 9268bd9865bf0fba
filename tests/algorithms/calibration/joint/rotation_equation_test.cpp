#include "algorithms/calibration/joint/rotation_equation.h"

#include <gtest/gtest.h>

#include "algorithms/messages/render.h"
#include "tests/algorithms/support/random_motion.h"

namespace remount::calibration {
namespace {

std::vector<TurnPair> turns(const Eigen::Matrix3d& a_from_b, const Eigen::Vector3d& amplitude_rad, double noise_rad,
                            int seed, int count = 200) {
  std::mt19937_64 random(static_cast<std::uint64_t>(seed));
  std::vector<TurnPair> pairs;
  for (int i = 0; i < count; ++i) {
    const Eigen::Matrix3d in_a = so3_exp(testing::random_vector(random, 1.0).cwiseProduct(amplitude_rad));
    pairs.push_back(
        {in_a * so3_exp(testing::random_vector(random, noise_rad)), a_from_b.transpose() * in_a * a_from_b});
  }
  return pairs;
}

TEST(rotation_equation, exact_turns_give_the_exact_rotation) {
  std::mt19937_64 random(3);
  for (int i = 0; i < 20; ++i) {
    const Eigen::Matrix3d a_from_b = testing::random_rotation(random);
    const RotationEquationResult found = solve_rotation_equation(turns(a_from_b, {0.05, 0.05, 0.2}, 0.0, i), 1e-6);
    EXPECT_TRUE(found.rotation_about_main_axis_observed);
    EXPECT_LT(so3_log(found.a_from_b * a_from_b.transpose()).norm(), 1e-9);
    EXPECT_LT(found.singular_values[3], 1e-12);
    EXPECT_GT(found.singular_values[2], 1e-2);
  }
}

TEST(rotation_equation, errors_are_as_large_as_the_covariance_says) {
  const Eigen::Matrix3d a_from_b = rotation_from_yaw_pitch_roll({0.5, -0.3, 1.0});
  double chi2 = 0.0;
  constexpr int kSeeds = 200;
  for (int seed = 0; seed < kSeeds; ++seed) {
    const RotationEquationResult found = solve_rotation_equation(turns(a_from_b, {0.05, 0.03, 0.2}, 0.002, seed), 1e-5);
    const Eigen::Vector3d error = so3_log(a_from_b * found.a_from_b.transpose());
    chi2 += error.dot(found.covariance_rad2.inverse() * error);
  }
  std::printf("  chi2 / n = %.2f\n", chi2 / (3.0 * kSeeds));
  // 600 degrees of freedom: the 1% limits are 0.87 and 1.14 of it. The soft weights count good turns as a little less
  // than one each, which makes the covariance larger by a tenth or so.
  EXPECT_GT(chi2 / (3.0 * kSeeds), 0.75);
  EXPECT_LT(chi2 / (3.0 * kSeeds), 1.14);
}

TEST(rotation_equation, turns_about_one_axis_leave_the_rotation_about_it_free_and_say_so) {
  const Eigen::Matrix3d a_from_b = rotation_from_yaw_pitch_roll({0.5, -0.1, 0.2});
  const RotationEquationResult found = solve_rotation_equation(turns(a_from_b, {0.0, 0.0, 0.2}, 0.001, 4), 1e-5);
  EXPECT_TRUE(found.solved);
  EXPECT_FALSE(found.rotation_about_main_axis_observed);
  EXPECT_NE(english(found.words).find("yaw"), std::string::npos) << found.words;
  EXPECT_LT(found.singular_values[2], 3.0 * found.singular_values[3]);
  const YawPitchRoll angles = yaw_pitch_roll_from_rotation(found.a_from_b);  // pitch and roll stand all the same
  EXPECT_NEAR(angles.pitch_rad, -0.1, 0.003);
  EXPECT_NEAR(angles.roll_rad, 0.2, 0.003);
}

TEST(rotation_equation, turns_that_disagree_are_out_voted) {
  const Eigen::Matrix3d a_from_b = rotation_from_yaw_pitch_roll({0.5, -0.1, 0.2});
  std::vector<TurnPair> pairs = turns(a_from_b, {0.1, 0.1, 0.2}, 0.001, 5);
  for (std::size_t i = 0; i < pairs.size(); i += 5) pairs[i].in_a = so3_exp({0.2, -0.1, 0.1});
  const RotationEquationResult found = solve_rotation_equation(pairs, 1e-5);
  EXPECT_LT(so3_log(found.a_from_b * a_from_b.transpose()).norm(), 0.003);
}

TEST(rotation_equation, no_turn_is_no_answer) {
  EXPECT_FALSE(solve_rotation_equation({}, 1e-4).solved);
  const RotationEquationResult still =
      solve_rotation_equation(turns(Eigen::Matrix3d::Identity(), {0, 0, 0}, 1e-5, 6), 1e-4);
  EXPECT_FALSE(still.solved);
  EXPECT_FALSE(still.words.empty());
}

TEST(planar_mounting, recovers_position_yaw_and_scale) {
  std::mt19937_64 random(8);
  for (const double scale : {1.0, 7.3, 0.02}) {
    const double yaw = 2.1;
    const Eigen::Vector2d lever(1.4, -0.6);
    std::vector<PlanarMotion> motions;
    for (int i = 0; i < 50; ++i) {
      PlanarMotion motion;
      motion.turn_rad = testing::random_vector(random, 0.2).x();
      motion.travel_m = {5.0, 0.5 * motion.turn_rad};
      const Eigen::Vector2d in_vehicle = Eigen::Rotation2Dd(motion.turn_rad) * lever - lever + motion.travel_m;
      motion.sensor_travel = Eigen::Rotation2Dd(-yaw) * in_vehicle / scale;
      motions.push_back(motion);
    }
    const PlanarMounting found = solve_planar_mounting(motions, false);
    EXPECT_TRUE(found.position_observed);
    EXPECT_NEAR(found.x_m, lever.x(), 1e-9);
    EXPECT_NEAR(found.y_m, lever.y(), 1e-9);
    EXPECT_NEAR(found.yaw_rad, yaw, 1e-12);
    EXPECT_NEAR(found.scale / scale, 1.0, 1e-12);
  }
  EXPECT_FALSE(solve_planar_mounting({}, true).solved);
}

TEST(planar_mounting, straight_driving_shows_yaw_and_no_position) {
  std::vector<PlanarMotion> motions(20);
  for (PlanarMotion& motion : motions) {
    motion.travel_m = {5.0, 0.0};
    motion.sensor_travel = Eigen::Rotation2Dd(-0.3) * motion.travel_m;
  }
  const PlanarMounting found = solve_planar_mounting(motions, true);
  EXPECT_TRUE(found.solved);
  EXPECT_FALSE(found.position_observed);
  EXPECT_NEAR(found.yaw_rad, 0.3, 1e-12);
  EXPECT_EQ(found.x_m, 0.0);
}

}  // namespace
}  // namespace remount::calibration
