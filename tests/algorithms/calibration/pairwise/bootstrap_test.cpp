#include "algorithms/calibration/pairwise/bootstrap.h"

#include <gtest/gtest.h>

#include <cmath>

#include "algorithms/core/index.h"
#include "tests/algorithms/support/random_motion.h"

namespace remount::calibration {
namespace {

// Pulls on the mean of `blocks` numbers of unit sigma, each in `per_block` measurements with the same error.
std::vector<BlockPull> pulls(int seed, int blocks, int per_block) {
  std::mt19937_64 random(static_cast<std::uint64_t>(seed));
  std::vector<BlockPull> out;
  for (int block = 0; block < blocks; ++block) {
    const Vector6d error = testing::random_step(random, 1.0, 1.0);
    for (int i = 0; i < per_block; ++i) out.push_back({error / (blocks * per_block), index_at(block)});
  }
  return out;
}

TEST(bootstrap, finds_the_error_of_the_mean_also_where_a_block_shares_its_errors) {
  for (const int per_block : {1, 10}) {
    double variance = 0.0;
    for (int seed = 0; seed < 20; ++seed)
      variance += bootstrap_covariance(pulls(seed, 50, per_block), 6).trace() / 6.0 / 20.0;
    EXPECT_NEAR(std::sqrt(variance * 50.0), 1.0, 0.1) << per_block << " a block: the number of blocks counts";
  }
}

TEST(bootstrap, is_what_resampling_gives) {
  constexpr int kBlocks = 30, kSamples = 4000;
  const std::vector<BlockPull> all = pulls(3, kBlocks, 1);
  std::mt19937_64 random(4);
  Matrix6d second = Matrix6d::Zero();
  Vector6d mean = Vector6d::Zero();
  for (int sample = 0; sample < kSamples; ++sample) {
    Vector6d moved = Vector6d::Zero();
    for (int i = 0; i < kBlocks; ++i) moved += all[random() % kBlocks].step;
    second += moved * moved.transpose() / kSamples;
    mean += moved / kSamples;
  }
  const Matrix6d resampled = (second - mean * mean.transpose()) * kBlocks / (kBlocks - 1.0);
  for (int i = 0; i < 6; ++i) EXPECT_NEAR(resampled(i, i) / bootstrap_covariance(all, 6)(i, i), 1.0, 0.1) << i;
}

TEST(bootstrap, claims_nothing_from_too_little) {
  EXPECT_EQ(bootstrap_covariance(pulls(1, 3, 10), 6).norm(), 0.0);
  EXPECT_GT(bootstrap_covariance(pulls(1, 4, 10), 6).norm(), 0.0);
  EXPECT_EQ(bootstrap_covariance({}, 6).norm(), 0.0);
}

}  // namespace
}  // namespace remount::calibration
