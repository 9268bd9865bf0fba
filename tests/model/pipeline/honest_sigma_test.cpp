// A few of the drives of tests/long/honest_sigma_of_thirty_drives_test.cpp.
#include "tests/support/honest_sigma.h"

#include "tests/support/draws.h"

namespace remount::pipeline {
namespace {

TEST(sigma_of_some_drives, passes_a_chi_square_test_for_every_observed_parameter) {
  testing::expect_honest_sigma(64, 100, 4);
}

TEST(sigma_of_some_drives, passes_it_with_a_sparse_sensor) {
  ONLY_IN_LONG_TESTS();
  testing::expect_honest_sigma(24, 400, 6);
}

}  // namespace
}  // namespace remount::pipeline
