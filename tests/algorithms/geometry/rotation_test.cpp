#include "algorithms/geometry/rotation.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/algorithms/support/random_motion.h"

namespace remount {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

const std::vector<double> kAngles_rad{0.0, 1e-12, 1e-8, 9.9e-5, 1.01e-4, 9.9e-4, 1.01e-3,
                                      0.1, 1.0,   2.0,  3.0,    3.1,     3.14};

Vector3d random_axis(std::mt19937_64& random) { return testing::random_vector(random, 1.0).normalized(); }

TEST(rotation, exp_is_a_rotation_and_log_its_inverse_from_zero_to_near_pi) {
  std::mt19937_64 random(1);
  for (const double angle : kAngles_rad)
    for (int i = 0; i < 20; ++i) {
      const Vector3d phi = angle * random_axis(random);
      const Matrix3d rotation = so3_exp(phi);
      EXPECT_LT((rotation * rotation.transpose() - Matrix3d::Identity()).norm(), 1e-14) << angle;
      EXPECT_NEAR(rotation.determinant(), 1.0, 1e-14) << angle;
      EXPECT_LT((so3_log(rotation) - phi).norm(), 1e-13 + 1e-14 * angle) << angle;
      EXPECT_LT((rotation - Eigen::AngleAxisd(angle, phi.normalized().squaredNorm() > 0.5 ? Vector3d(phi.normalized())
                                                                                          : Vector3d(Vector3d::UnitX()))
                                .toRotationMatrix())
                    .norm(),
                1e-14)
          << angle;
    }
}

TEST(rotation, log_at_pi_is_one_of_the_two_answers_and_never_longer_than_pi) {
  std::mt19937_64 random(2);
  for (const double below : {0.0, 1e-15, 1e-9, 1e-6})
    for (int i = 0; i < 50; ++i) {
      const Vector3d phi = (kPi - below) * random_axis(random);
      const Vector3d back = so3_log(so3_exp(phi));
      EXPECT_LE(back.norm(), kPi + 1e-14);
      EXPECT_LT((so3_exp(back) - so3_exp(phi)).norm(), 1e-13) << below;
    }
  EXPECT_NEAR(so3_log(Vector3d(1, -1, -1).asDiagonal()).norm(), kPi, 1e-15);
}

TEST(rotation, left_jacobian_and_its_inverse_agree_with_perturbation) {
  std::mt19937_64 random(3);
  constexpr double kStep = 1e-6;
  for (const double angle : kAngles_rad)
    for (int i = 0; i < 5; ++i) {
      const Vector3d phi = angle * random_axis(random);
      Matrix3d numeric;
      for (int axis = 0; axis < 3; ++axis) {
        const Vector3d d = kStep * Vector3d::Unit(axis);
        numeric.col(axis) = so3_log(so3_exp(phi + d) * so3_exp(phi - d).transpose()) / (2.0 * kStep);
      }
      const Matrix3d analytic = so3_left_jacobian(phi);
      EXPECT_LT((analytic - numeric).norm(), 1e-9) << "angle " << angle;
      EXPECT_LT((analytic * so3_left_jacobian_inverse(phi) - Matrix3d::Identity()).norm(), 1e-11) << "angle " << angle;
    }
  EXPECT_TRUE(so3_left_jacobian_inverse(Vector3d(0, 0, kPi)).allFinite());
}

TEST(rotation, yaw_pitch_roll_returns_what_it_was_given) {
  for (double yaw = -3.1; yaw < 3.15; yaw += 0.4)
    for (double pitch = -1.5; pitch < 1.55; pitch += 0.25)
      for (double roll = -3.1; roll < 3.15; roll += 0.4) {
        const YawPitchRoll back = yaw_pitch_roll_from_rotation(rotation_from_yaw_pitch_roll({yaw, pitch, roll}));
        EXPECT_NEAR(back.yaw_rad, yaw, 1e-13);
        EXPECT_NEAR(back.pitch_rad, pitch, 1e-13);
        EXPECT_NEAR(back.roll_rad, roll, 1e-13);
      }
}

TEST(rotation, yaw_turns_x_towards_y_and_pitch_turns_x_down) {
  const Vector3d x = Vector3d::UnitX(), y = Vector3d::UnitY();
  EXPECT_LT((rotation_from_yaw_pitch_roll({kPi / 2, 0, 0}) * x - Vector3d(0, 1, 0)).norm(), 1e-15);
  EXPECT_LT((rotation_from_yaw_pitch_roll({0, kPi / 2, 0}) * x - Vector3d(0, 0, -1)).norm(), 1e-15);
  EXPECT_LT((rotation_from_yaw_pitch_roll({0, 0, kPi / 2}) * y - Vector3d(0, 0, 1)).norm(), 1e-15);
}

TEST(rotation, at_the_poles_roll_is_zero_and_the_rotation_is_kept) {
  for (const double pitch : {kPi / 2, -kPi / 2})
    for (const double yaw : {-3.0, 0.3, 2.0}) {
      const Matrix3d rotation = rotation_from_yaw_pitch_roll({yaw, pitch, 0.7});
      const YawPitchRoll back = yaw_pitch_roll_from_rotation(rotation);
      EXPECT_EQ(back.roll_rad, 0.0);
      EXPECT_LT((rotation_from_yaw_pitch_roll(back) - rotation).norm(), 1e-9) << pitch << " " << yaw;
    }
}

TEST(rotation, yaw_pitch_roll_jacobian_agrees_with_perturbation) {
  std::mt19937_64 random(4);
  constexpr double kStep = 1e-6;
  for (int i = 0; i < 100; ++i) {
    const Matrix3d rotation = testing::random_rotation(random);
    const YawPitchRoll at = yaw_pitch_roll_from_rotation(rotation);
    if (std::abs(at.pitch_rad) > 1.4) continue;
    Matrix3d numeric;
    for (int axis = 0; axis < 3; ++axis) {
      const Vector3d d = kStep * Vector3d::Unit(axis);
      const YawPitchRoll plus = yaw_pitch_roll_from_rotation(so3_exp(d) * rotation);
      const YawPitchRoll minus = yaw_pitch_roll_from_rotation(so3_exp(-d) * rotation);
      numeric.col(axis) << wrap_angle_rad(plus.yaw_rad - minus.yaw_rad), plus.pitch_rad - minus.pitch_rad,
          wrap_angle_rad(plus.roll_rad - minus.roll_rad);
    }
    EXPECT_LT((yaw_pitch_roll_jacobian(at) - numeric / (2.0 * kStep)).norm(), 1e-7) << "pitch " << at.pitch_rad;
  }
}

TEST(rotation, nearest_rotation_is_a_rotation_no_other_is_nearer) {
  std::mt19937_64 random(5);
  for (int i = 0; i < 50; ++i) {
    const Matrix3d rotation = testing::random_rotation(random);
    EXPECT_LT((nearest_rotation(rotation) - rotation).norm(), 1e-13);
    Matrix3d disturbed = rotation;
    for (int column = 0; column < 3; ++column) disturbed.col(column) += testing::random_vector(random, 0.05);
    const Matrix3d nearest = nearest_rotation(disturbed);
    EXPECT_LT((nearest * nearest.transpose() - Matrix3d::Identity()).norm(), 1e-13);
    EXPECT_NEAR(nearest.determinant(), 1.0, 1e-13);
    const double distance = (nearest - disturbed).norm();
    for (int other = 0; other < 20; ++other)
      EXPECT_LE(distance, (so3_exp(testing::random_vector(random, 0.02)) * nearest - disturbed).norm() + 1e-14);
    EXPECT_NEAR(nearest_rotation(-disturbed).determinant(), 1.0, 1e-13);  // never a reflection
  }
}

TEST(rotation, wrap_keeps_the_angle_and_its_range) {
  for (double angle = -20.0; angle < 20.0; angle += 0.37) {
    const double wrapped = wrap_angle_rad(angle);
    EXPECT_GT(wrapped, -kPi);
    EXPECT_LE(wrapped, kPi);
    EXPECT_NEAR(std::remainder(wrapped - angle, 2.0 * kPi), 0.0, 1e-12);
  }
  EXPECT_EQ(wrap_angle_rad(-kPi), kPi);
  EXPECT_EQ(wrap_angle_rad(kPi), kPi);
}

TEST(rigid_transform, difference_undoes_perturbed_and_six_parameters_return) {
  std::mt19937_64 random(6);
  for (int i = 0; i < 50; ++i) {
    const RigidTransform from = testing::random_rigid(random, 3.0), to = testing::random_rigid(random, 3.0);
    EXPECT_LT(testing::distance_of(perturb(from, difference(from, to)), to), 1e-12);
    EXPECT_LT(testing::distance_of(rigid_from_six(six_from_rigid(from)), from), 1e-12);
    EXPECT_NEAR(rotation_angle_between_rad(from, to), difference(from, to).tail<3>().norm(), 1e-12);
  }
}

}  // namespace
}  // namespace remount
