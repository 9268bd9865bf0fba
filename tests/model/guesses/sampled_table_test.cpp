#include "model/guesses/sampled_table.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

namespace remount::guesses {
namespace {

std::string rows(const std::string& row, int count = 10) {
  std::string text;
  for (int i = 0; i < count; ++i) text += row + "\n";
  return text;
}

SampledTable sampled(const std::string& text) {
  const auto table = sample_table("t", text);
  EXPECT_TRUE(table) << text.substr(0, 60);
  return table.value_or(SampledTable{});
}

TEST(sampled_table, separators_and_decimals_are_told_by_what_makes_numbers) {
  const auto look = [](const std::string& row, char separator, bool commas, std::size_t columns) {
    const SampledTable table = sampled(rows(row));
    EXPECT_EQ(table.text.separator, separator) << row;
    EXPECT_EQ(table.text.decimal_commas, commas) << row;
    EXPECT_EQ(table.columns.size(), columns) << row;
  };
  look("1.5,2.5,3", ',', false, 3);
  look("1,5;2,5;3", ';', true, 3);
  look("1;2;3", ';', false, 3);
  look("1.5\t2\t3", '\t', false, 3);
  look("1,5\t2,25", '\t', true, 2);
  look("  1.5   2  3 4", ' ', false, 4);
  look("1|2|3", '|', false, 3);
  look("2023-11-14 22:13:20.5,1,2", ',', false, 3);
}

TEST(sampled_table, names_units_and_what_stands_above_are_told_from_rows) {
  const SampledTable named = sampled("project: x\nt,lat (deg),lon (deg)\n" + rows("1,2,3"));
  EXPECT_TRUE(named.named);
  EXPECT_EQ(named.text.skip_lines, 1U);
  EXPECT_EQ(named.columns[1].title, "lat (deg)");
  EXPECT_EQ(named.ref(1).name, "lat (deg)");
  const SampledTable units = sampled("t,lat,lon\n(s),(deg),(deg)\n" + rows("1,2,3"));
  EXPECT_FALSE(units.named) << "the units would be a row";
  EXPECT_EQ(units.columns[2].unit, "(deg)");
  EXPECT_EQ(units.columns[2].title, "lon");
  EXPECT_EQ(units.text.skip_lines, 2U);
  const SampledTable comment = sampled("# t x (m) y\n" + rows("1 2 3"));
  EXPECT_FALSE(comment.named) << "a unit apart is a word of its own";
  EXPECT_EQ(comment.columns[1].title, "x (m)");
  const SampledTable twice = sampled("a,a,b\n" + rows("1,2,3"));
  EXPECT_FALSE(twice.named) << "one name is of two columns";
  const SampledTable bare = sampled(rows("1,2,3"));
  EXPECT_FALSE(bare.named);
  EXPECT_EQ(bare.text.skip_lines, 0U);
}

TEST(sampled_table, columns_are_numbers_dates_or_words) {
  const SampledTable table = sampled(rows("1.5,7,2023-11-14T22:13:20Z,22:13:20.5,2023-11-14,good,nan"));
  EXPECT_TRUE(table.columns[0].numeric && !table.columns[0].whole);
  EXPECT_TRUE(table.columns[1].whole);
  EXPECT_TRUE(table.columns[2].date);
  EXPECT_DOUBLE_EQ(table.columns[2].values[0], 1'700'000'000.0);
  EXPECT_TRUE(table.columns[3].clock);
  EXPECT_DOUBLE_EQ(std::fmod(table.columns[3].values[0], 86'400.0), 80'000.5);
  EXPECT_TRUE(table.columns[4].day);
  EXPECT_EQ(table.columns[5].texts, std::vector<std::string>{"good"});
  EXPECT_FALSE(table.columns[6].numeric) << "a column without any value is nothing";
}

TEST(sampled_table, nines_far_outside_stand_for_no_value) {
  std::string text = "t,a,b,c\n";
  for (int i = 0; i < 20; ++i)
    text += std::to_string(i) + (i % 4 == 1 ? ",-9999" : ",12.5") + "," + std::to_string(-10'010 + i) + ",N/A\n";
  const SampledTable table = sampled(text);
  EXPECT_EQ(table.text.no_value, -9999.0);
  EXPECT_EQ(table.no_value_in, std::vector<std::string>{"a"}) << "b goes through that number";
  EXPECT_TRUE(table.columns[1].numeric && std::isnan(table.columns[1].values[1]));
  EXPECT_FALSE(table.columns[3].numeric);
  EXPECT_FALSE(sampled("t,b\n" + rows("1,-9999")).text.no_value) << "nothing else stands there";
}

TEST(sampled_table, prose_and_nothing_are_no_tables) {
  EXPECT_FALSE(sample_table("t", ""));
  EXPECT_FALSE(sample_table("t", "\n\n\n"));
  EXPECT_FALSE(sample_table("t", rows("words, and more words")));
  EXPECT_FALSE(sample_table("t", "1,2,3\n4,5,6\n")) << "too few rows to tell";
}

TEST(sampled_table, of_a_long_table_some_rows_are_kept) {
  const SampledTable table = sampled(rows("1,2,3", 100'000));
  EXPECT_EQ(table.rows, 100'000U);
  EXPECT_LT(table.columns[0].values.size(), 25'000U);
  EXPECT_GT(table.columns[0].values.size(), 10'000U);
}

}  // namespace
}  // namespace remount::guesses
