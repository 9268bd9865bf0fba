#include "tests/support/slew_recordings.h"

#include <gtest/gtest.h>

namespace remount {
namespace {

TEST(slew_recordings, errors_over_many_simulated_recordings_are_as_large_as_said) {
  constexpr int kSeeds = 40;
  for (const FirstPlane first : {FirstPlane::Ground, FirstPlane::Turn}) {
    const std::array<double, 6> squares = squares_over_recordings(first, 100, kSeeds);
    for (std::size_t i = 0; i < 6; ++i) {
      // 40 degrees of freedom: the 0.1% limits are 0.45 and 1.84.
      EXPECT_GT(squares[i], 0.45) << kParameterNames[i];
      EXPECT_LT(squares[i], 1.84) << kParameterNames[i];
    }
  }
}

}  // namespace
}  // namespace remount
