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

TEST(lasting_errors, too_few_and_none_are_no_reason_to_widen) {
  EXPECT_EQ(lasting_factor({}, 3.0), 1.0);
  EXPECT_EQ(lasting_factor({1.0, 1.0, 1.0}, 3.0), 1.0);
  EXPECT_EQ(lasting_factor(std::vector<double>(50, 0.0), 3.0), 1.0);
}

}  // namespace
}  // namespace remount
