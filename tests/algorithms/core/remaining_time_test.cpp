#include "algorithms/core/remaining_time.h"

#include <gtest/gtest.h>

#include <vector>

namespace remount {
namespace {

/// What is said once a second of a step of 100 items, where `done_at` says how many are done after so many seconds.
template <class DoneAt>
std::vector<std::optional<double>> said(double lasts_s, DoneAt&& done_at) {
  RemainingTime remaining;
  std::vector<std::optional<double>> all;
  for (double time_s = 0.0; time_s < lasts_s; time_s += 1.0)
    all.push_back(remaining.left_s(time_s, std::floor(done_at(time_s)), 100.0));
  return all;
}

TEST(remaining_time, counts_down_where_items_take_equally_long) {
  const auto all = said(100.0, [](double time_s) { return time_s; });
  for (std::size_t i = 4; i < 99; ++i) {
    ASSERT_TRUE(all[i]) << i;
    EXPECT_NEAR(*all[i], 100.0 - static_cast<double>(i), 2.0) << i;
  }
}

TEST(remaining_time, never_stands_nor_grows_while_it_is_said) {
  // The last items take ten times as long: their mean says the same for most of the step.
  const auto slower = [](double time_s) { return time_s < 20.0 ? 4.0 * time_s : 80.0 + (time_s - 20.0) / 10.0; };
  const auto all = said(220.0, slower);
  std::size_t known = 0;
  for (std::size_t i = 1; i < all.size(); ++i) {
    known += all[i] ? 1 : 0;
    if (!all[i] || !all[i - 1]) continue;
    EXPECT_NEAR(*all[i - 1] - *all[i], 1.0, 1e-9) << i;
  }
  std::printf("  said in %zu of %zu seconds\n", known, all.size());
  EXPECT_GT(known, 10U);
  EXPECT_LT(known, all.size());
}

TEST(remaining_time, says_nothing_before_anything_is_done_and_where_nothing_comes) {
  RemainingTime remaining;
  EXPECT_FALSE(remaining.left_s(5.0, 0.0, 100.0));
  EXPECT_FALSE(remaining.left_s(0.5, 10.0, 100.0));
  EXPECT_FALSE(remaining.left_s(100.0, 100.0, 100.0));
  std::size_t known = 0;
  const auto stuck = said(600.0, [](double time_s) { return std::min(10.0, time_s); });
  for (std::size_t i = 60; i < stuck.size(); ++i) known += stuck[i] ? 1 : 0;
  std::printf("  said in %zu of 540 seconds in which nothing was done\n", known);
  EXPECT_LT(known, 100U);
}

}  // namespace
}  // namespace remount
