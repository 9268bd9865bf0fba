#include "algorithms/geometry/lasting_errors.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace remount {
namespace {

std::vector<double> linked_errors(double link, int seed, int count = 400) {
  std::mt19937_64 random(static_cast<std::uint64_t>(seed));
  std::normal_distribution<double> normal;
  std::vector<double> errors;
  double error = normal(random);
  for (int i = 0; i < count; ++i) {
    errors.push_back(error);
    error = link * error + std::sqrt(1.0 - link * link) * normal(random);
  }
  return errors;
}

double mean_factor(double link) {
  constexpr int kSeeds = 100;
  double sum = 0.0;
  for (int seed = 0; seed < kSeeds; ++seed) sum += lasting_factor(linked_errors(link, seed), 0.0) / kSeeds;
  return sum;
}

TEST(lasting_errors, independent_errors_count_one_by_one) {
  EXPECT_GE(mean_factor(0.0), 1.0);
  EXPECT_LT(mean_factor(0.0), 1.1);
}

TEST(lasting_errors, linked_errors_count_for_as_many_as_are_independent) {
  for (const double link : {0.5, 0.8}) EXPECT_NEAR(mean_factor(link) * (1.0 - link) / (1.0 + link), 1.0, 0.25) << link;
}

TEST(lasting_errors, what_a_fit_takes_out_is_put_back) {
  double with = 0.0, without = 0.0;
  for (int seed = 0; seed < 50; ++seed) {
    const std::vector<double> errors = linked_errors(0.8, seed, 120);
    with += lasting_factor(errors, 3.0);
    without += lasting_factor(errors, 0.0);
  }
  EXPECT_GT(with, 1.1 * without);
}

// A mean of linked errors: its variance is (1 + link) / (1 - link) times that of independent ones.
double mean_widening(double link) {
  constexpr int kSeeds = 100;
  double sum = 0.0;
  for (int seed = 0; seed < kSeeds; ++seed) {
    std::vector<double> errors = linked_errors(link, seed);
    double mean = 0.0;
    for (const double error : errors) mean += error / static_cast<double>(errors.size());
    Eigen::MatrixXd scores(errors.size(), 1);
    for (std::size_t i = 0; i < errors.size(); ++i) scores(static_cast<Eigen::Index>(i), 0) = errors[i] - mean;
    const Eigen::MatrixXd covariance = Eigen::MatrixXd::Constant(1, 1, 1.0 / static_cast<double>(errors.size()));
    sum += lasting_widening(covariance, scores)[0] / kSeeds;
  }
  return sum;
}

TEST(lasting_errors, an_unknown_is_widened_as_long_as_errors_last) {
  EXPECT_GE(mean_widening(0.0), 1.0);
  EXPECT_LT(mean_widening(0.0), 1.15);
  for (const double link : {0.8, 0.95}) {
    const double right = std::sqrt((1.0 + link) / (1.0 - link));
    EXPECT_GT(mean_widening(link), 0.75 * right) << link;
    EXPECT_LT(mean_widening(link), 1.4 * right) << link;
  }
}

TEST(lasting_errors, no_rows_are_no_reason_to_widen_an_unknown) {
  EXPECT_EQ(lasting_widening(Eigen::MatrixXd::Identity(2, 2), Eigen::MatrixXd(0, 2)), Eigen::VectorXd::Ones(2));
}

TEST(lasting_errors, too_few_and_none_are_no_reason_to_widen) {
  EXPECT_EQ(lasting_factor({}, 3.0), 1.0);
  EXPECT_EQ(lasting_factor({1.0, 1.0, 1.0}, 3.0), 1.0);
  EXPECT_EQ(lasting_factor(std::vector<double>(50, 0.0), 3.0), 1.0);
}

}  // namespace
}  // namespace remount
