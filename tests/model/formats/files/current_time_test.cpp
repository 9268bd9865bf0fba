#include "model/formats/files/current_time.h"

#include <gtest/gtest.h>

#include <chrono>
#include <cstdio>
#include <cstdlib>

#include "model/formats/files/time_stamp.h"

namespace remount::formats {
namespace {

TEST(current_time, is_said_to_the_second) {
  const std::string said = now_in_utc();
  std::printf("  %s\n", said.c_str());
  ASSERT_EQ(said.size(), std::string("2011-09-26 13:02:25 UTC").size());
  EXPECT_TRUE(said.ends_with(" UTC"));
  const auto read_ns = parse_date_ns(said.substr(0, said.size() - 4));
  ASSERT_TRUE(read_ns);
  const std::chrono::nanoseconds now = std::chrono::system_clock::now().time_since_epoch();
  EXPECT_LT(std::abs(now.count() - *read_ns), 60'000'000'000) << "a minute";
}

}  // namespace
}  // namespace remount::formats
