// Dates as tables and names of files write them.
#include "model/formats/files/calendar_text.h"

#include <gtest/gtest.h>

#include "model/formats/files/input_file.h"
#include "model/formats/files/time_stamp.h"

namespace remount::formats {
namespace {

constexpr std::int64_t kDate_ns = 1'700'000'000'050'000'000;  // 2023-11-14 22:13:20.050

TEST(calendar_text, zones_halves_of_a_day_and_milliseconds_behind_a_colon) {
  for (const char* text : {"2023-11-14T22:13:20.05Z", "2023-11-15T06:13:20.050+08:00", "2023-11-14T17:13:20.050-0500",
                           "2023-11-14 23:13:20.050 +01", "2023-11-14 22:13:20:050", "2023/11/14 10:13:20.050 PM",
                           "2023-11-14 22:13:20.050 GMT", "2023-11-14 10:13:20.050pm"})
    EXPECT_EQ(parse_calendar_ns(text), kDate_ns) << text;
  EXPECT_EQ(parse_calendar_ns("2023-11-14 12:00:00 AM"), parse_date_ns("2023-11-14 00:00:00"));
  EXPECT_EQ(parse_calendar_ns("2023-11-14 12:00:00 PM"), parse_date_ns("2023-11-14 12:00:00"));
  EXPECT_EQ(parse_calendar_ns("2023-11-14 22-13-20-0500"), parse_date_ns("2023-11-14 22-13-20-0500"))
      << "a fraction apart by a dash is no zone";
  for (const char* text : {"2023-11-14 22:13:20 PM", "2023-11-14 00:13:20 AM", "2023-11-14 22:13:20+25:00",
                           "2023-11-14 22:13:20+08:07", "2023-11-14 22:13:20:05x", "22:13:20 PM", "PM", "+08:00", ""})
    EXPECT_FALSE(parse_calendar_ns(text)) << text;
}

TEST(calendar_text, two_digits_are_a_year_where_nothing_else_can_be_meant) {
  EXPECT_EQ(parse_calendar_ns("14.11.23 22:13:20.05", DateOrder::DayFirst), kDate_ns);
  EXPECT_EQ(parse_calendar_ns("11/14/23 10:13:20.05 PM", DateOrder::MonthFirst), kDate_ns);
  EXPECT_EQ(parse_calendar_ns("14.11.99 00:00:00", DateOrder::DayFirst), parse_date_ns("1999-11-14 00:00:00"));
  for (const char* text : {"14/11/23 22:13:20", "14-11-23 22:13:20", "14.11.123 22:13:20"})
    EXPECT_FALSE(parse_calendar_ns(text, DateOrder::DayFirst)) << text;
  for (const char* text : {"11/12/23 22:13:20", "11.14.23 22:13:20"})
    EXPECT_FALSE(parse_calendar_ns(text, DateOrder::MonthFirst)) << text;
}

TEST(time_stamp, dates_in_names_of_files) {
  for (const char* stem :
       {"2023-11-14_22-13-20.050000", "20231114_221320_050", "20231114_221320.050", "20231114221320050",
        "2023-11-14_22:13:20.050000", "2023-11-14-22-13-20_050", "2023-11-14T22-13-20.050Z", "2023-11-14_22-13-20-050",
        "lidar_2023-11-14T22-13-20.050", "20231114T221320.05Z", "2023.11.14_22.13.20.050", "20231114221320050000"})
    EXPECT_EQ(date_in_name_ns(stem), kDate_ns) << stem;
  EXPECT_EQ(date_in_name_ns("scan3_20231114_221320_top"), kDate_ns / 1'000'000'000 * 1'000'000'000);
  for (const char* stem :
       {"1700000000050000000", "1700000000.050", "20231114", "20231314_221320", "20231114_221320_05",
        "2023111422132005", "20231114_221320_050_7", "17001114_221320", "20231114.221320", "2023-11/14_22-13-20",
        "2023-11-14", "000017", "", "2023-11-14_22-13-20.0500000001", "20231114_221361", "2023111422132005000"})
    EXPECT_FALSE(date_in_name_ns(stem)) << stem;
}

TEST(input_file, what_stands_for_no_value) {
  for (const char* field : {"", " ", "nan", "NaN", "-nan", "N/A", "n/a", "-", "--", "null", "None", "#N/A"})
    EXPECT_TRUE(is_no_value(field)) << field;
  for (const char* field : {"0", "-1", "-9999", "n", "inf", "nano", "unknown", "none of these"})
    EXPECT_FALSE(is_no_value(field)) << field;
}

}  // namespace
}  // namespace remount::formats
