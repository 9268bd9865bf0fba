#include "algorithms/calibration/joint/pair_equation.h"

#include <gtest/gtest.h>

#include "tests/algorithms/support/random_motion.h"

namespace remount::calibration {
namespace {

TEST(pair_equation, the_residual_of_an_exact_pair_is_zero) {
  std::mt19937_64 random(1);
  for (int i = 0; i < 50; ++i) {
    const RigidTransform x = testing::random_rigid(random, 1.0);
    const search::MotionPair pair = testing::exact_pairs(random, x, 1).front();
    EXPECT_LT(linearise_pair(pair.ins_b_from_ins_a, pair.lidar_b_from_lidar_a, x).residual.norm(), 1e-12);
  }
}

TEST(pair_equation, the_residual_is_what_was_registered_too_little_in_the_axes_of_the_later_lidar) {
  std::mt19937_64 random(5);
  double worst = 0.0;
  for (int i = 0; i < 50; ++i) {
    const RigidTransform x = testing::random_rigid(random, 1.0);
    const search::MotionPair pair = testing::exact_pairs(random, x, 1).front();
    const Vector6d wrong = testing::random_step(random, 0.3, 0.05);
    // Registered so that this much, about the axes of lidar b, is missing to the motion that the INS predicts.
    const RigidTransform predicted = predicted_lidar_motion(pair.ins_b_from_ins_a, x);
    const RigidTransform registered = make_rigid(so3_exp(Eigen::Vector3d(-wrong.tail<3>())) * predicted.linear(),
                                                 predicted.translation() - wrong.head<3>());
    worst = std::max(worst, (motion_residual(pair.ins_b_from_ins_a, registered, x) - wrong).norm());
  }
  std::printf("six components of the residual: off by %.1e at most\n", worst);
  EXPECT_LT(worst, 1e-12);
}

TEST(pair_equation, all_three_jacobians_agree_with_central_differences) {
  std::mt19937_64 random(2);
  constexpr double kStep = 1e-5;
  for (int trial = 0; trial < 50; ++trial) {
    const RigidTransform x = testing::random_rigid(random, 1.0);
    const RigidTransform pose_a = testing::random_rigid(random, 5.0);
    const RigidTransform pose_b =
        pose_a * make_rigid(so3_exp(testing::random_vector(random, 0.3)), testing::random_vector(random, 5.0));
    const RigidTransform q =
        perturb(predicted_lidar_motion(pose_b.inverse() * pose_a, x), testing::random_step(random, 0.2, 0.2));
    const auto residual = [&](const RigidTransform& a, const RigidTransform& b, const RigidTransform& mounting) {
      return linearise_pair(b.inverse() * a, q, mounting).residual;
    };
    const PairEquation at = linearise_pair(pose_b.inverse() * pose_a, q, x);
    Matrix6d d_x, d_a, d_b;
    for (int i = 0; i < 6; ++i) {
      const Vector6d d = kStep * Vector6d::Unit(i);
      d_x.col(i) = residual(pose_a, pose_b, perturb(x, d)) - residual(pose_a, pose_b, perturb(x, -d));
      d_a.col(i) = residual(moved_in_body(pose_a, d), pose_b, x) - residual(moved_in_body(pose_a, -d), pose_b, x);
      d_b.col(i) = residual(pose_a, moved_in_body(pose_b, d), x) - residual(pose_a, moved_in_body(pose_b, -d), x);
    }
    EXPECT_LT((at.d_x - d_x / (2 * kStep)).cwiseAbs().maxCoeff(), 1e-6) << "X, trial " << trial;
    EXPECT_LT((at.d_a - d_a / (2 * kStep)).cwiseAbs().maxCoeff(), 1e-6) << "pose a, trial " << trial;
    EXPECT_LT((at.d_b - d_b / (2 * kStep)).cwiseAbs().maxCoeff(), 1e-6) << "pose b, trial " << trial;
  }
}

TEST(pair_equation, all_four_jacobians_across_lidars_agree_with_central_differences) {
  std::mt19937_64 random(3);
  constexpr double kStep = 1e-5;
  for (int trial = 0; trial < 50; ++trial) {
    const RigidTransform x_a = testing::random_rigid(random, 1.0), x_b = testing::random_rigid(random, 1.0);
    const RigidTransform pose_a = testing::random_rigid(random, 5.0);
    const RigidTransform pose_b =
        pose_a * make_rigid(so3_exp(testing::random_vector(random, 0.3)), testing::random_vector(random, 5.0));
    const RigidTransform q =
        perturb(predicted_cross_motion(pose_b.inverse() * pose_a, x_a, x_b), testing::random_step(random, 0.2, 0.2));
    const auto residual = [&](const RigidTransform& a, const RigidTransform& b, const RigidTransform& of_a,
                              const RigidTransform& of_b) {
      return linearise_cross_pair(b.inverse() * a, q, of_a, of_b).residual;
    };
    const CrossEquation at = linearise_cross_pair(pose_b.inverse() * pose_a, q, x_a, x_b);
    Matrix6d d_x_a, d_x_b, d_a, d_b;
    for (int i = 0; i < 6; ++i) {
      const Vector6d d = kStep * Vector6d::Unit(i);
      d_x_a.col(i) = residual(pose_a, pose_b, perturb(x_a, d), x_b) - residual(pose_a, pose_b, perturb(x_a, -d), x_b);
      d_x_b.col(i) = residual(pose_a, pose_b, x_a, perturb(x_b, d)) - residual(pose_a, pose_b, x_a, perturb(x_b, -d));
      d_a.col(i) =
          residual(moved_in_body(pose_a, d), pose_b, x_a, x_b) - residual(moved_in_body(pose_a, -d), pose_b, x_a, x_b);
      d_b.col(i) =
          residual(pose_a, moved_in_body(pose_b, d), x_a, x_b) - residual(pose_a, moved_in_body(pose_b, -d), x_a, x_b);
    }
    EXPECT_LT((at.d_x_a - d_x_a / (2 * kStep)).cwiseAbs().maxCoeff(), 1e-6) << "X of a, trial " << trial;
    EXPECT_LT((at.d_x_b - d_x_b / (2 * kStep)).cwiseAbs().maxCoeff(), 1e-6) << "X of b, trial " << trial;
    EXPECT_LT((at.d_a - d_a / (2 * kStep)).cwiseAbs().maxCoeff(), 1e-6) << "pose a, trial " << trial;
    EXPECT_LT((at.d_b - d_b / (2 * kStep)).cwiseAbs().maxCoeff(), 1e-6) << "pose b, trial " << trial;
  }
}

TEST(pair_equation, across_one_lidar_is_that_of_one) {
  std::mt19937_64 random(4);
  const RigidTransform x = testing::random_rigid(random, 1.0), p = testing::random_rigid(random, 3.0);
  const RigidTransform q = perturb(predicted_lidar_motion(p, x), testing::random_step(random, 0.1, 0.1));
  const PairEquation one = linearise_pair(p, q, x);
  const CrossEquation two = linearise_cross_pair(p, q, x, x);
  EXPECT_LT((two.residual - one.residual).norm(), 1e-12);
  EXPECT_LT((two.d_x_a + two.d_x_b - one.d_x).norm(), 1e-12);
  EXPECT_LT((two.d_a - one.d_a).norm() + (two.d_b - one.d_b).norm(), 1e-12);
}

}  // namespace
}  // namespace remount::calibration
