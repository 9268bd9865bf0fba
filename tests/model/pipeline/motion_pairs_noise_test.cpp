// Ten draws of the noise of motion pairs; a hundred of each kind and number: tests/long/motion_pairs_sweep_test.cpp.
#include "tests/support/noisy_motion_pairs.h"

namespace remount::pipeline {
namespace {

TEST(motion_pairs_solution, holds_and_errs_as_its_sigmas_say_whatever_the_noise) {
  for (const testing::PairMotion motion : testing::kPairMotions)
    for (const int count : {40, 200}) testing::expect_solved_whatever_the_noise(motion, count, 10);
}

}  // namespace
}  // namespace remount::pipeline
