#include "algorithms/calibration/pairwise/clock_estimate.h"

#include <gtest/gtest.h>

#include <cmath>

namespace remount::calibration {
namespace {

// Keyframes at 10 m/s whose speed swings by `swing_mps` to either side.
std::vector<JointNode> nodes_at(double swing_mps) {
  std::vector<JointNode> nodes(200);
  for (std::size_t i = 0; i < nodes.size(); ++i)
    nodes[i].body_velocity[0] = 10.0 + (i % 2 == 0 ? swing_mps : -swing_mps);
  return nodes;
}

constexpr motion::SessionIndex kFirst{0};

TEST(doubted_lag, is_believed_where_the_speed_changes_and_hardly_where_it_is_even) {
  constexpr double kSigma_s = 1e-3, kPrior_s = 1.0;
  EXPECT_NEAR(doubted_lag_sigma_s(nodes_at(2.0), kFirst, kSigma_s, kPrior_s), std::sqrt(1.01) * kSigma_s, 1e-8);
  EXPECT_NEAR(doubted_lag_sigma_s(nodes_at(0.1), kFirst, kSigma_s, kPrior_s), std::sqrt(5.0) * kSigma_s, 1e-8);
}

TEST(doubted_lag, is_never_known_worse_than_before_nor_better_than_the_solution_says) {
  for (const double prior_s : {0.03, 1.0}) {
    EXPECT_NEAR(doubted_lag_sigma_s(nodes_at(0.0), kFirst, 1e-3, prior_s), prior_s, 1e-9) << "nothing changes";
    EXPECT_NEAR(doubted_lag_sigma_s(nodes_at(0.01), kFirst, prior_s, prior_s), prior_s, 1e-9) << "nothing was told";
  }
  EXPECT_GE(doubted_lag_sigma_s(nodes_at(100.0), kFirst, 1e-3, 1.0), 1e-3);
  EXPECT_NEAR(doubted_lag_sigma_s(nodes_at(100.0), kFirst, 1e-3, 1.0, true), 2e-3, 1e-6) << "a narrow field";
}

TEST(doubted_lag, counts_no_keyframe_whose_velocity_is_not_known) {
  std::vector<JointNode> nodes = nodes_at(0.1);
  const double known_s = doubted_lag_sigma_s(nodes, kFirst, 1e-3, 1.0);
  for (std::size_t i = 0; i < nodes.size(); i += 20) nodes.insert(nodes.begin() + signed_of(i), JointNode{});
  EXPECT_NEAR(doubted_lag_sigma_s(nodes, kFirst, 1e-3, 1.0), known_s, 0.01 * known_s);
}

}  // namespace
}  // namespace remount::calibration
