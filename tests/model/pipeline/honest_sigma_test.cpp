// Sparse sensors and other scenarios: tests/long.
#include "tests/support/thirty_drives.h"

namespace remount {
namespace {

TEST(sigma_of_thirty_drives, passes_a_chi_square_test_for_every_observed_parameter) {
  testing::expect_honest_sigma(64, 100);
}

}  // namespace
}  // namespace remount
