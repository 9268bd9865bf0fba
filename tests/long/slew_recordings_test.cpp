#include "tests/support/slew_recordings.h"

#include <gtest/gtest.h>

namespace remount::testing {
namespace {

void expect_as_said(const simulator::SlewYardOptions& options, int first_seed) {
  constexpr int kSeeds = 40;
  for (const std::array<double, 6>& squares : squares_over_recordings(first_seed, kSeeds, options)) {
    for (std::size_t i = 0; i < 6; ++i) {
      // 40 degrees of freedom: the 0.1% limits are 0.44 and 1.84.
      EXPECT_GT(squares[i], 0.44) << to_string(calibration::kParameters[i]);
      EXPECT_LT(squares[i], 1.84) << to_string(calibration::kParameters[i]);
    }
  }
}

TEST(slew_recordings, errors_over_many_simulated_recordings_are_as_large_as_said) { expect_as_said({}, 100); }

TEST(slew_recordings, so_are_they_on_a_slope_of_two_degrees) {
  simulator::SlewYardOptions options;
  options.slope_deg = 2.0;
  expect_as_said(options, 200);
}

}  // namespace
}  // namespace remount::testing
