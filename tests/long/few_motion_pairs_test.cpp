// Three hundred draws of a handful of motion pairs. Takes a minute.
#include "tests/support/few_motion_pairs.h"

namespace remount::testing {
namespace {

TEST(three_hundred_draws_of_a_handful, err_by_more_than_three_sigma_in_less_than_one_case_in_a_hundred) {
  expect_honest_handful(300);
}

TEST(three_hundred_draws_of_a_handful, that_share_keyframes_do_so_as_rarely) { expect_honest_links(300); }

}  // namespace
}  // namespace remount::testing
