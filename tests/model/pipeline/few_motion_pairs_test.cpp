// Some of the draws of tests/long/few_motion_pairs_test.cpp.
#include "tests/support/few_motion_pairs.h"

#include "tests/support/draws.h"

namespace remount::pipeline {
namespace {

TEST(motion_pairs_solution, a_handful_of_pairs_errs_by_more_than_three_sigma_in_less_than_one_case_in_a_hundred) {
  testing::expect_honest_handful(testing::some_of_many(60, 24));
}

TEST(motion_pairs_solution, pairs_that_share_keyframes_err_by_more_than_three_sigma_as_rarely) {
  testing::expect_honest_links(testing::some_of_many(60, 24));
}

}  // namespace
}  // namespace remount::pipeline
