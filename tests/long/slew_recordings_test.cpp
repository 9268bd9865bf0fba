#include "tests/support/slew_recordings.h"

#include <gtest/gtest.h>

namespace remount {
namespace {

TEST(slew_recordings, errors_over_many_simulated_recordings_are_no_larger_than_said) {
  constexpr int kSeeds = 40;
  for (const FirstPlane first : {FirstPlane::Ground, FirstPlane::Turn}) {
    const std::array<double, 6> squares = squares_over_recordings(first, 100, kSeeds);
    for (std::size_t i = 0; i < 6; ++i) {
      // 40 degrees of freedom: the 0.1% limit is 1.84.
      EXPECT_LT(squares[i], 1.84) << kParameterNames[i];
    }
  }
}

}  // namespace
}  // namespace remount
