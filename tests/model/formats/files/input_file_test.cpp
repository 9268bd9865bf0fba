#include "model/formats/files/input_file.h"

#include <gtest/gtest.h>

#include <clocale>

#include "model/formats/files/csv_table.h"
#include "model/formats/files/time_stamp.h"
#include "tests/model/formats/temporary_folder.h"

namespace remount::formats {
namespace {

TEST(input_file, numbers_are_strict_and_finite) {
  EXPECT_EQ(parse_number(" -1.5e3 "), -1500.0);
  EXPECT_EQ(parse_number("+2"), 2.0);
  for (const char* text : {"", " ", "1,5", "1.5x", "nan", "inf", "0x10", "--1", "+", "1e999"})
    EXPECT_FALSE(parse_number(text)) << text;
  EXPECT_TRUE(parse_any_number("nan"));
  EXPECT_FALSE(parse_integer("1.0"));
  EXPECT_FALSE(parse_integer("99999999999999999999"));
  EXPECT_ERROR(require_number("abc", "yaw", "ins.csv", 7), "ins.csv:7: yaw is 'abc'");
}

TEST(input_file, numbers_may_have_behind_them_what_instruments_write) {
  struct Case {
    const char* text;
    double value;
    const char* unit;
    char side;
  };
  for (const Case& one : {Case{" 250.1 m ", 250.1, "m", '\0'},
                          {"-3.5m/s", -3.5, "m/s", '\0'},
                          {"12.5 deg", 12.5, "deg", '\0'},
                          {"48.125\xc2\xb0 N", 48.125, "deg", 'N'},
                          {"48.125\xb0S", 48.125, "deg", 'S'},
                          {"4807.038W", 4807.038, "", 'W'},
                          {"1e-3", 1e-3, "", '\0'}}) {
    const auto number = parse_labelled_number(one.text);
    ASSERT_TRUE(number) << one.text;
    EXPECT_EQ(number->value, one.value) << one.text;
    EXPECT_EQ(number->unit, one.unit) << one.text;
    EXPECT_EQ(number->side, one.side) << one.text;
  }
  EXPECT_EQ(parse_labelled_number("0.5W")->signed_value(), -0.5);
  for (const char* text :
       {"", "m", "N", "1.5 mm", "1.5 km/h", "-48.1 S", "48.1 NE", "12.5 deg m", "1.5x", "nan", "1,5 m", "2 S m"})
    EXPECT_FALSE(parse_labelled_number(text)) << text;
}

TEST(input_file, lines_of_old_spreadsheets_end_in_carriage_returns) {
  LineReader old("a,b\r1,2\r3,4"), mixed("a\r\nb\rc\n");
  std::string_view line;
  std::string all;
  while (old.next(line)) all += std::string(line) + "|";
  EXPECT_EQ(all, "a,b|1,2|3,4|");
  EXPECT_EQ(old.line_number(), 3U);
  ASSERT_TRUE(mixed.next(line));
  EXPECT_EQ(line, "a");
  ASSERT_TRUE(mixed.next(line));
  EXPECT_EQ(line, "b\rc");
}

TEST(input_file, columns_between_other_separators_are_named) {
  EXPECT_ERROR(CsvHeader("t;x;y").require("x", "ins.csv"), "ins.csv:1: its columns are separated by semicolons");
  EXPECT_ERROR(CsvHeader("t\tx\ty").require("x", "ins.csv"), "ins.csv:1: its columns are separated by tabs");
}

TEST(input_file, numbers_do_not_depend_on_the_locale) {
  const std::string before = std::setlocale(LC_ALL, nullptr);
  if (std::setlocale(LC_ALL, "de_DE.UTF-8") == nullptr) std::setlocale(LC_ALL, "C.UTF-8");
  EXPECT_EQ(parse_number("1.5"), 1.5);
  EXPECT_EQ(parse_seconds_ns("1.5"), 1'500'000'000);
  std::setlocale(LC_ALL, before.c_str());
}

TEST(input_file, seconds_keep_every_nanosecond) {
  EXPECT_EQ(parse_seconds_ns("1636512749.922900677"), 1'636'512'749'922'900'677);
  EXPECT_EQ(parse_seconds_ns("86.553"), 86'553'000'000);
  EXPECT_EQ(parse_seconds_ns("-0.5"), -500'000'000);
  EXPECT_EQ(parse_seconds_ns("-2.25"), -2'250'000'000);
  EXPECT_EQ(parse_seconds_ns("1.5e3"), 1'500'000'000'000);
  for (const char* text : {"", "abc", "1.63715E+18", "99999999999999999999", "1.2.3"})
    EXPECT_FALSE(parse_seconds_ns(text)) << text;
}

TEST(input_file, csv_keeps_commas_within_quotes) {
  std::vector<std::string_view> fields;
  split_csv("1, \"(0.0, 0.0)\" ,,3\r", fields);
  EXPECT_EQ(fields, (std::vector<std::string_view>{"1", "(0.0, 0.0)", "", "3"}));
}

TEST(input_file, a_line_is_taken_apart_into_a_bounded_number_of_fields) {
  std::vector<std::string_view> fields;
  const std::string commas(1 << 20, ',');
  const std::string line = "1" + commas;
  split_csv(line, fields);
  EXPECT_EQ(fields.size(), kMostFieldsOfLine);
  EXPECT_EQ(fields.front(), "1");
  EXPECT_EQ(fields.back().size(), commas.size() - kMostFieldsOfLine + 1) << "what follows is one";
  std::string words;
  for (std::size_t i = 0; i < 2 * kMostFieldsOfLine; ++i) words += "7 ";
  split_blanks(words, fields);
  EXPECT_EQ(fields.size(), kMostFieldsOfLine);
  EXPECT_EQ(fields[1], "7");
  EXPECT_FALSE(parse_number(fields.back()));
}

TEST(input_file, lines_of_any_ending) {
  LineReader lines(
      "\xEF\xBB\xBF"
      "a\r\nb\n\nc");
  std::vector<std::string> found;
  for (std::string_view line; lines.next(line);) found.emplace_back(line);
  EXPECT_EQ(found, (std::vector<std::string>{"a", "b", "", "c"}));
  EXPECT_EQ(lines.line_number(), 4u);
}

TEST(input_file, size_is_bounded) {
  const TemporaryFolder folder;
  const auto file = folder.write("a", "12345");
  EXPECT_EQ(read_regular_file(file, 5), "12345");
  EXPECT_ERROR(read_regular_file(file, 4), "holds 5 bytes, at most 4 bytes are read");
  EXPECT_EQ(read_file_head(file, 2), "12");
}

TEST(time_stamp, dates_of_both_kinds) {
  EXPECT_EQ(parse_date_ns("2011-09-26 13:02:25.964389445"), 1'317'042'145'964'389'445);
  EXPECT_EQ(parse_date_ns("2021-10-26-16-21-29-468"), 1'635'265'289'468'000'000);
  EXPECT_EQ(format_date_ns(1'317'042'145'964'389'445), "2011-09-26 13:02:25.964389445");
  for (const char* text : {"", "2011-13-01 00:00:00", "2011-02-30 00:00:00", "2011-09-26 25:00:00", "2011-09-26", "abc",
                           "2011-09-26 13:02:25.9643894451", "2011-09-26 13:02:25.12x"})
    EXPECT_FALSE(parse_date_ns(text)) << text;
}

TEST(time_stamp, sums_stay_within_the_times_of_files) {
  constexpr std::int64_t kLast_ns = 8'000'000'000'000'000'000;
  for (const std::int64_t sign : {1, -1}) {
    EXPECT_TRUE(is_stamp(sign * kLast_ns));
    EXPECT_FALSE(is_stamp(sign * (kLast_ns + 1)));
    EXPECT_EQ(moved_ns(sign * (kLast_ns - 5), sign * 5), sign * kLast_ns);
    EXPECT_FALSE(moved_ns(sign * kLast_ns, sign * kLast_ns));
  }
}

TEST(time_stamp, gps_time_with_leap_seconds) {
  // The GPS epoch; and around the leap second at the end of 2016: GPS runs on, UTC repeats a second.
  EXPECT_EQ(unix_ns_from_gps_week(0, 0), 315'964'800'000'000'000);
  constexpr std::int64_t kNewYear2017 = 1'483'228'800;
  constexpr std::int64_t kGpsOfIt = kNewYear2017 - 315'964'800 + 18;
  EXPECT_EQ(leap_seconds_at_gps_s(kGpsOfIt), 18);
  EXPECT_EQ(unix_ns_from_gps_ns(kGpsOfIt * 1'000'000'000), kNewYear2017 * 1'000'000'000);
  EXPECT_EQ(leap_seconds_at_gps_s(kGpsOfIt - 2), 17);
  EXPECT_EQ(leap_seconds_at_gps_s(1'000'000'000), 15);  // September 2011
  EXPECT_EQ(unix_ns_from_gps_week(2183, 269'353'560'000'000), 1'636'512'535'560'000'000);
  EXPECT_FALSE(unix_ns_from_gps_week(-1, 0));
  EXPECT_FALSE(unix_ns_from_gps_week(2183, 604'800'000'000'001));
}

}  // namespace
}  // namespace remount::formats
