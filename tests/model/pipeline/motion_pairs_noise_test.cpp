// Some draws of the noise of motion pairs; a hundred of each kind and number: tests/long/motion_pairs_sweep_test.cpp.
#include "tests/support/draws.h"
#include "tests/support/noisy_motion_pairs.h"

namespace remount::pipeline {
namespace {

TEST(motion_pairs_solution, holds_and_errs_as_its_sigmas_say_whatever_the_noise) {
  for (const testing::PairMotion motion : testing::kPairMotions)
    for (const int count : {40, 200})
      testing::expect_solved_whatever_the_noise(motion, count, testing::some_of_many(10, 4));
}

// Whole steps along the height, which hardly shows, went to and fro by 27 m for ever.
TEST(motion_pairs_solution, is_found_where_steps_along_what_is_not_observed_go_to_and_fro) {
  ONLY_IN_LONG_TESTS();
  testing::NoisyMotionPairs drive = testing::noisy_motion_pairs(testing::PairMotion::StraightWithTwoTurns, 2000, 37);
  Progress progress;
  const calibration::CalibrationResult result = solve_motion_pairs(drive.keyframes, drive.pairs, {}, {}, progress);
  ASSERT_TRUE(calibration::is_usable(result)) << english(result.message);
  EXPECT_FALSE(result.known[calibration::Parameter::Z].observed);
  testing::expect_within_sigma(result, drive.ins_from_lidar, 3.5);
}

}  // namespace
}  // namespace remount::pipeline
