#include "model/formats/files/number_text.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "model/formats/files/input_file.h"

namespace remount::formats {
namespace {

TEST(number_text, exact_texts_read_back_to_the_same_number) {
  for (const double value : {0.1, -0.25, 1e-300, -1.7976931348623157e308, 3.0, 1636512749.922900677})
    EXPECT_EQ(parse_number(exact_text(value)), value) << exact_text(value);
  EXPECT_EQ(exact_text(std::numeric_limits<double>::quiet_NaN()), "nan");
}

TEST(number_text, zero_has_no_sign) {
  EXPECT_EQ(exact_text(-0.0), "0");
  EXPECT_EQ(rounded_text(-0.00004, 4), "0.0000");
  EXPECT_EQ(rounded_text(-0.4, 0), "0");
  EXPECT_EQ(rounded_text(-0.00006, 4), "-0.0001");
  EXPECT_EQ(rounded_text(-10.0, 0), "-10");
  EXPECT_EQ(rounded_text(2.5, 1), "2.5");
}

TEST(number_text, differences_have_a_sign_where_they_are_something) {
  EXPECT_EQ(signed_text(0.00006, 4), "+0.0001");
  EXPECT_EQ(signed_text(-0.00006, 4), "-0.0001");
  EXPECT_EQ(signed_text(0.00004, 4), "0.0000");
  EXPECT_EQ(signed_text(-0.00004, 4), "0.0000");
}

TEST(number_text, a_spread_is_never_nothing) {
  EXPECT_EQ(spread_text(0.00123, 4), "0.0012");
  EXPECT_EQ(spread_text(0.00003, 4), "< 0.0001");
  EXPECT_EQ(spread_text(5e-7, 6), "< 0.000001") << "it rounds to the even digit";
  EXPECT_EQ(spread_text(0.3, 0), "< 1");
  EXPECT_EQ(spread_text(0.0, 2), "0.00") << "of what is known exactly";
}

TEST(number_text, patterns_are_those_of_printf) { EXPECT_EQ(format_numbers("%+.2f, %d", 0.5, 7), "+0.50, 7"); }

}  // namespace
}  // namespace remount::formats
