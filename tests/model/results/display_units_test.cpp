#include "model/results/display_units.h"

#include <gtest/gtest.h>

#include <limits>

namespace remount::results {
namespace {

TEST(display_units, a_value_has_the_decimals_that_two_digits_of_its_sigma_need) {
  for (const auto& [sigma, decimals] : {std::pair(0.013, 3),
                                        {0.00075, 5},
                                        {0.0999, 2},
                                        {0.1, 2},
                                        {0.0034, 4},
                                        {0.25, 2},
                                        {1.4, 1},
                                        {23.0, 0},
                                        {500.0, 0},
                                        {1e-9, 6},
                                        {0.0, 6}})
    EXPECT_EQ(justified_decimals(sigma), decimals) << sigma;
  EXPECT_EQ(justified_decimals(std::numeric_limits<double>::quiet_NaN()), 6);
}

}  // namespace
}  // namespace remount::results
