#include "algorithms/calibration/pairwise/noise_prior.h"

#include <gtest/gtest.h>

#include "tests/algorithms/support/simulated_drive.h"

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

// Registered anew, some pairs are wrong by what an INS that states no noise may well be wrong by, and by much more than
// this one was.
TEST(noise_prior, pairs_that_are_registered_anew_are_judged_by_the_noise_that_was_found_before) {
  testing::DriveOptions options;
  options.keyframes = 80;
  options.noise.ins_position_sigma_m = 1e-3;
  options.noise.ins_attitude_sigma_rad = 2e-5;
  options.noise.registration_scale = 1.0;
  const testing::SimulatedDrive drive = testing::simulate(options, 5);
  PairwiseInput input = testing::input_of(drive, options);
  input.sessions.assign(1, SessionNoise());
  std::vector<motion::Pair> pairs = testing::pairs_of(drive);
  PairwiseDetails first;
  const CalibrationResult before = solve_pairwise(input, pairs, first, {});
  ASSERT_EQ(before.status, Status::Ok);

  std::vector<motion::Pair> anew = testing::pairs_of(drive);
  for (std::size_t i = 0; i < anew.size(); i += 5)
    anew[i].lidar_b_from_lidar_a.rotate(so3_exp({0.0, 0.0, degrees_to_radians(0.15)}));
  const auto wrong_that_pass = [&](const std::optional<NoiseModel>& noise_before) {
    input.noise_before = noise_before;
    std::vector<motion::Pair> judged = anew;
    PairwiseDetails details;
    const CalibrationResult result = solve_pairwise(input, judged, details, {});
    int passed = 0;
    for (std::size_t i = 0; i < judged.size(); i += 5) passed += judged[i].state == motion::PairState::Accepted ? 1 : 0;
    std::printf(
        "  %s: %d wrong ones pass, attitude noise %.2g rad, %.4f deg off\n",
        noise_before ? "by the noise before" : "by what is expected", passed, details.noise.ins_attitude_sigma_rad,
        radians_to_degrees(rotation_angle_between_rad(result.mounting.reference_from_sensor, testing::mounting())));
    return passed;
  };
  EXPECT_GT(wrong_that_pass(std::nullopt), 0) << "otherwise this shows nothing";
  EXPECT_EQ(wrong_that_pass(first.noise), 0);
}

}  // namespace
}  // namespace remount::calibration
