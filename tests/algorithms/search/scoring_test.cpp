#include "algorithms/search/scoring.h"

#include <gtest/gtest.h>

#include <cmath>

#include "algorithms/core/error.h"
#include "algorithms/core/symmetric_eigen.h"
#include "tests/algorithms/support/random_motion.h"

namespace remount::search {
namespace {

// Pairs that no X satisfies, with different weights.
std::vector<MotionPair> inconsistent_pairs(std::mt19937_64& random, int count) {
  std::vector<MotionPair> pairs = testing::exact_pairs(random, testing::random_rigid(random, 1.0), count);
  for (MotionPair& pair : pairs) {
    pair.lidar_b_from_lidar_a = perturb(pair.lidar_b_from_lidar_a, testing::random_step(random, 0.3, 0.1));
    pair.weight = 0.2 + std::abs(testing::random_vector(random, 1.0).x());
  }
  return pairs;
}

// ||P X - X Q||_F^2 of the 4 x 4 matrices, the translation column over the length: the definition.
double squared_norm(const MotionPair& pair, const RigidTransform& x, double length_m) {
  Eigen::Matrix4d error = pair.ins_b_from_ins_a.matrix() * x.matrix() - x.matrix() * pair.lidar_b_from_lidar_a.matrix();
  error.col(3) /= length_m;
  return error.squaredNorm();
}

TEST(scoring, frobenius_sum_is_the_sum_of_the_norms_of_its_definition) {
  std::mt19937_64 random(1);
  const std::vector<MotionPair> pairs = inconsistent_pairs(random, 30);
  for (const double length_m : {1.0, 10.0}) {
    const RigidTransform x = testing::random_rigid(random, 2.0);
    double sum = 0.0;
    for (const MotionPair& pair : pairs) sum += std::sqrt(squared_norm(pair, x, length_m));
    EXPECT_NEAR(frobenius_sum(pairs, x, length_m), sum, 1e-10);
  }
  const RigidTransform x = testing::random_rigid(random, 2.0);
  EXPECT_LT(frobenius_sum(testing::exact_pairs(random, x, 30), x, 1.0), 1e-12);
}

TEST(scoring, the_quadratic_form_is_the_weighted_sum_of_squares) {
  std::mt19937_64 random(2);
  const std::vector<MotionPair> pairs = inconsistent_pairs(random, 40);
  for (const double length_m : {1.0, 10.0}) {
    const QuadraticForm form(pairs, length_m);
    for (int i = 0; i < 20; ++i) {
      const RigidTransform x = testing::random_rigid(random, 2.0);
      double sum = 0.0;
      for (const MotionPair& pair : pairs) sum += pair.weight * squared_norm(pair, x, length_m);
      EXPECT_NEAR(form.value(x) / sum, 1.0, 1e-9);
    }
  }
}

TEST(scoring, many_at_a_time_and_on_a_grid_agree_with_the_sum_of_squares) {
  std::mt19937_64 random(6);
  const std::vector<MotionPair> pairs = inconsistent_pairs(random, 40);
  const QuadraticForm form(pairs, 1.0);
  const auto naive = [&](const RigidTransform& x) {
    double sum = 0.0;
    for (const MotionPair& pair : pairs) sum += pair.weight * squared_norm(pair, x, 1.0);
    return sum;
  };
  for (const std::size_t count : {0UL, 1UL, 7UL, 8UL, 9UL, 61UL}) {
    std::vector<RigidTransform> candidates;
    std::vector<Eigen::Vector3d> translations;
    for (std::size_t i = 0; i < count; ++i) {
      candidates.push_back(testing::random_rigid(random, 2.0));
      translations.emplace_back(testing::random_vector(random, 2.0));
    }
    std::vector<double> values(count), on_grid(count);
    form.values(candidates, values);
    const Eigen::Matrix3d rotation = testing::random_rotation(random);
    form.values_on_grid(rotation, form.prepare_grid(translations), on_grid);
    for (std::size_t i = 0; i < count; ++i) {
      EXPECT_NEAR(values[i] / naive(candidates[i]), 1.0, 1e-9);
      EXPECT_NEAR(on_grid[i] / naive(make_rigid(rotation, translations[i])), 1.0, 1e-9);
    }
  }
  std::vector<RigidTransform> three(3);
  std::vector<double> two(2);
  EXPECT_THROW(form.values(three, two), Error);
  EXPECT_THROW(form.values_on_grid(testing::random_rotation(random), form.prepare_grid({}), two), Error);
}

TEST(scoring, the_sum_of_norms_and_the_sum_of_squares_agree_where_they_must) {
  std::mt19937_64 random(7);
  // One pair of weight 1: the square of the norm. Several: between the square over their number and the square.
  for (int count = 1; count <= 5; ++count) {
    std::vector<MotionPair> pairs = inconsistent_pairs(random, count);
    for (MotionPair& pair : pairs) pair.weight = 1.0;
    const QuadraticForm form(pairs, 1.0);
    for (int i = 0; i < 20; ++i) {
      const RigidTransform x = testing::random_rigid(random, 2.0);
      const double sum = frobenius_sum(pairs, x, 1.0), squares = form.value(x);
      EXPECT_LE(squares, sum * sum * (1.0 + 1e-9));
      EXPECT_GE(squares, sum * sum / count * (1.0 - 1e-9));
    }
  }
  // On exact pairs both vanish at the truth and nowhere else, so that their best candidate is the same.
  const RigidTransform truth = testing::random_rigid(random, 1.0);
  const std::vector<MotionPair> exact = testing::exact_pairs(random, truth, 20);
  const QuadraticForm form(exact, 1.0);
  EXPECT_LT(frobenius_sum(exact, truth, 1.0), 1e-12);
  EXPECT_LT(std::abs(form.value(truth)), 1e-10);
  EXPECT_GT(form.value(perturb(truth, testing::random_step(random, 0.1, 0.1))), 1e-3);
}

TEST(scoring, best_translation_is_the_minimum_for_its_rotation) {
  std::mt19937_64 random(3);
  const QuadraticForm form(inconsistent_pairs(random, 40), 1.0);
  for (int i = 0; i < 20; ++i) {
    const Eigen::Matrix3d rotation = testing::random_rotation(random);
    const Eigen::Vector3d best_m = form.best_translation_m(rotation, testing::random_vector(random, 5.0));
    const double least = form.value(make_rigid(rotation, best_m));
    EXPECT_NEAR(form.reduced(rotation).value / least, 1.0, 1e-9);
    for (int other = 0; other < 10; ++other)
      EXPECT_GT(form.value(make_rigid(rotation, best_m + testing::random_vector(random, 0.1))), least);
  }
}

TEST(scoring, what_the_pairs_do_not_determine_stays_near) {
  std::mt19937_64 random(4);
  const RigidTransform x = testing::random_rigid(random, 1.0);
  const QuadraticForm planar(testing::exact_pairs(random, x, 30, {0, 0, 1}, {1, 1, 0}), 1.0);
  const Eigen::Vector3d best_m = planar.best_translation_m(x.linear(), {7.0, 8.0, 9.0});
  EXPECT_LT((best_m.head<2>() - x.translation().head<2>()).norm(), 1e-9);
  EXPECT_NEAR(best_m.z(), 9.0, 1e-9);
}

TEST(scoring, reduced_gradient_agrees_with_perturbation) {
  std::mt19937_64 random(5);
  constexpr double kStep = 1e-5;
  const QuadraticForm form(inconsistent_pairs(random, 40), 10.0);
  for (int i = 0; i < 20; ++i) {
    const Eigen::Matrix3d rotation = testing::random_rotation(random);
    const QuadraticForm::Reduced at = form.reduced(rotation);
    Eigen::Vector3d numeric;
    for (int axis = 0; axis < 3; ++axis) {
      const Eigen::Vector3d d = kStep * Eigen::Vector3d::Unit(axis);
      numeric[axis] =
          (form.reduced(so3_exp(d) * rotation).value - form.reduced(so3_exp(-d) * rotation).value) / (2.0 * kStep);
    }
    EXPECT_LT((at.gradient - numeric).norm(), 1e-6 * (1.0 + at.gradient.norm())) << numeric.transpose();
    EXPECT_GE(symmetric_eigen(at.curvature).eigenvalues()[0], -1e-9);
  }
}

}  // namespace
}  // namespace remount::search
