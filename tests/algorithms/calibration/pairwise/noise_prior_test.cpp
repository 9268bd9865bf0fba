#include "algorithms/calibration/pairwise/noise_prior.h"

#include <gtest/gtest.h>

namespace remount::calibration {
namespace {

TEST(noise_prior, a_declared_drift_is_not_estimated_smaller_and_an_assumed_one_may_be) {
  PairwiseInput input;
  SessionNoise drifting, silent;
  drifting.position_drift = 0.02, drifting.attitude_drift = 4e-4;
  input.sessions = {drifting, drifting};
  NoiseModel estimated;
  estimated.ins_position_drift = 0.015, estimated.ins_attitude_drift = 6e-4;
  const NoiseModel kept = with_declared_drift(estimated, noise_prior(input));
  EXPECT_DOUBLE_EQ(kept.ins_position_drift, 0.02);
  EXPECT_DOUBLE_EQ(kept.ins_attitude_drift, 6e-4) << "more is seen than is declared";
  input.sessions = {silent};
  const NoisePrior assumed = noise_prior(input);
  EXPECT_GT(assumed.expected.ins_position_drift, 0.0) << "the options' drift is the start of the search";
  EXPECT_DOUBLE_EQ(with_declared_drift(estimated, assumed).ins_position_drift, 0.015);
}

}  // namespace
}  // namespace remount::calibration
