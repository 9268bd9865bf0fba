// A hundred draws of noise for each kind and number of motion pairs.
#include "tests/support/noisy_motion_pairs.h"

namespace remount::testing {
namespace {

TEST(hundred_draws_of_motion_pairs, are_solved_and_err_as_their_sigmas_say) {
  for (const PairMotion motion : kPairMotions)
    for (const int count : {40, 200, 2000}) expect_solved_whatever_the_noise(motion, count, 100);
}

}  // namespace
}  // namespace remount::testing
