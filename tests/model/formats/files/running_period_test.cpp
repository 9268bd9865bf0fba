#include "model/formats/files/running_period.h"

#include <gtest/gtest.h>

#include <cstdio>
#include <vector>

namespace remount::formats {
namespace {

using Times = std::vector<std::int64_t>;

constexpr std::int64_t kPeriodSecond_ns = 1'000'000'000, kBroken_s = -1, kDay_s = 86'400, kWeek_s = 7 * kDay_s;

/// What becomes of times in seconds, one after the other; kBroken_s of those that are.
Times running_s(RunningPeriod period, const Times& times_s) {
  Times running;
  for (const std::int64_t time_s : times_s) {
    const auto now_ns = period.running_ns(time_s * kPeriodSecond_ns);
    running.push_back(now_ns ? *now_ns / kPeriodSecond_ns : kBroken_s);
    std::printf("  %lld s: %lld s\n", static_cast<long long>(time_s), static_cast<long long>(running.back()));
  }
  return running;
}

TEST(running_period, goes_on_over_every_end) {
  EXPECT_EQ(running_s(count_days(), {86'399, 0, 43'200, 86'399, 1}),
            (Times{86'399, kDay_s, kDay_s + 43'200, kDay_s + 86'399, 2 * kDay_s + 1}));
  EXPECT_EQ(running_s(count_weeks(), {604'799, 0, 302'000, 604'000, 1}),
            (Times{604'799, kWeek_s, kWeek_s + 302'000, kWeek_s + 604'000, 2 * kWeek_s + 1}));
  EXPECT_EQ(running_s(count_weeks(), {604'799, 604'801, 604'803}), (Times{604'799, 604'801, 604'803}))
      << "of a table that does not begin anew";
}

// Sentences of one time come one after the other, and those of another receiver among them.
TEST(running_period, what_comes_late_is_of_the_day_before) {
  EXPECT_EQ(running_s(count_days(), {86'399, 0, 86'399, 1}), (Times{86'399, kDay_s, 86'399, kDay_s + 1}));
  RunningPeriod days = count_days();
  days.running_ns(0);
  EXPECT_EQ(days.running_ns(kUtcDay_ns - 1), -1) << "before the first midnight";
  EXPECT_EQ(days.latest_ns(), 0);
}

TEST(running_period, a_jump_is_broken_until_another_time_agrees) {
  EXPECT_EQ(running_s(count_days(), {1'000, 80'000, 1'001, 1'002}), (Times{1'000, kBroken_s, 1'001, 1'002}));
  EXPECT_EQ(running_s(count_days(), {1'000, 80'000, 80'000, 1'001}), (Times{1'000, kBroken_s, kBroken_s, 1'001}))
      << "sentences of one time may all be broken";
  EXPECT_EQ(running_s(count_weeks(), {1'000, 500'000, 500'000, 1'001}), (Times{1'000, kBroken_s, kBroken_s, 1'001}));
  EXPECT_EQ(running_s(count_days(), {1'000, 80'000, 80'001}), (Times{1'000, kBroken_s, 80'001}));
}

TEST(running_period, a_broken_time_that_looks_like_the_next_period_is_taken_back) {
  EXPECT_EQ(running_s(count_days(), {86'390, 60, 86'391, 86'392}), (Times{86'390, kDay_s + 60, 86'391, 86'392}));
  EXPECT_EQ(running_s(count_weeks(), {604'790, 60, 604'791}), (Times{604'790, kWeek_s + 60, 604'791}));
}

TEST(running_period, behind_a_fall_a_day_has_paused_and_a_week_was_broken_before) {
  EXPECT_EQ(running_s(count_days(), {86'000, 18'000, 18'001, 18'002}),
            (Times{86'000, kBroken_s, kDay_s + 18'001, kDay_s + 18'002}));
  EXPECT_EQ(running_s(count_weeks(), {600'000, 100'000, 100'001, 100'002}),
            (Times{600'000, kBroken_s, 100'001, 100'002}));
}

}  // namespace
}  // namespace remount::formats
