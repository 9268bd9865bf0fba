#include "tests/support/thirty_drives.h"

namespace remount {
namespace {

TEST(sigma_of_thirty_drives, passes_a_chi_square_test_with_a_sparse_sensor) { testing::expect_honest_sigma(24, 400); }

}  // namespace
}  // namespace remount
