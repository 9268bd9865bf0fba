#include "algorithms/calibration/bootstrap.h"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <cmath>

#include "tests/algorithms/support/random_motion.h"

namespace remount {
namespace {

// Measurements of six numbers with unit sigma each, `per_block` of them with the same error.
std::vector<PairInfluence> measurements(int seed, int blocks, int per_block) {
  std::mt19937_64 random(static_cast<std::uint64_t>(seed));
  std::vector<PairInfluence> out;
  for (int block = 0; block < blocks; ++block) {
    const Vector6d error = random_step(random, 1.0, 1.0);
    for (int i = 0; i < per_block; ++i) out.push_back({Matrix6d::Identity(), error, block});
  }
  return out;
}

TEST(bootstrap, finds_the_error_of_the_mean_also_where_a_block_shares_its_errors) {
  for (const int per_block : {1, 10}) {
    double variance = 0.0;
    for (int seed = 0; seed < 20; ++seed)
      variance +=
          bootstrap_covariance(measurements(seed, 50, per_block), Matrix6d::Zero(), 200, 1, {}).trace() / 6.0 / 20.0;
    EXPECT_NEAR(std::sqrt(variance * 50.0), 1.0, 0.1) << per_block << " a block: the number of blocks counts";
  }
}

TEST(bootstrap, same_seed_same_bytes_other_seed_other_sample) {
  const std::vector<PairInfluence> pairs = measurements(1, 20, 3);
  const Matrix6d first = bootstrap_covariance(pairs, Matrix6d::Zero(), 50, 7, {});
  EXPECT_TRUE(first == bootstrap_covariance(pairs, Matrix6d::Zero(), 50, 7, {}));
  EXPECT_FALSE(first == bootstrap_covariance(pairs, Matrix6d::Zero(), 50, 8, {}));
  EXPECT_GE(Eigen::SelfAdjointEigenSolver<Matrix6d>(first).eigenvalues()[0], 0.0);
}

TEST(bootstrap, claims_nothing_from_too_little) {
  EXPECT_EQ(bootstrap_covariance(measurements(1, 3, 10), Matrix6d::Zero(), 50, 1, {}).norm(), 0.0);
  EXPECT_EQ(bootstrap_covariance({}, Matrix6d::Identity(), 50, 1, {}).norm(), 0.0);
  EXPECT_EQ(bootstrap_covariance(measurements(1, 20, 1), Matrix6d::Zero(), 0, 1, {}).norm(), 0.0);
  std::stop_source stop;
  stop.request_stop();
  const Progress cancelled(stop.get_token());
  EXPECT_TRUE(bootstrap_covariance(measurements(1, 20, 1), Matrix6d::Zero(), 50, 1, cancelled).allFinite());
}

}  // namespace
}  // namespace remount
