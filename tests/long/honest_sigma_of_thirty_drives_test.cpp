// Errors of thirty drives each with a dense and a sparse sensor, against the stated sigma. Takes four minutes.
#include "tests/support/honest_sigma.h"

namespace remount::testing {
namespace {

TEST(sigma_of_thirty_drives, passes_a_chi_square_test_for_every_observed_parameter) {
  expect_honest_sigma(64, 100, 30);
}

TEST(sigma_of_thirty_drives, passes_it_with_a_sparse_sensor) { expect_honest_sigma(24, 400, 30); }

}  // namespace
}  // namespace remount::testing
