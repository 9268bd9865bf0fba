// Units of time by their names: one table for all readers.
#include "model/formats/files/time_unit.h"

#include <gtest/gtest.h>

namespace remount::formats {
namespace {

TEST(time_unit, goes_by_its_name_and_back_by_the_short_one) {
  for (const auto& [name, unit_ns] : {std::pair{"s", 1'000'000'000},
                                      {"seconds", 1'000'000'000},
                                      {"msec", 1'000'000},
                                      {"us", 1'000},
                                      {"\xc2\xb5s", 1'000},
                                      {"\xce\xbcs", 1'000},
                                      {"microseconds", 1'000},
                                      {"nsec", 1}})
    EXPECT_EQ(time_unit_named_ns(name), unit_ns) << name;
  for (const char* name : {"", "m", "min", "deg", "S"}) EXPECT_FALSE(time_unit_named_ns(name)) << name;
  EXPECT_EQ(time_unit_name(1'000'000'000), "s");
  EXPECT_EQ(time_unit_name(1'000), "us");
  EXPECT_EQ(time_unit_name(60), "");
}

}  // namespace
}  // namespace remount::formats
