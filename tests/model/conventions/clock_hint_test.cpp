#include "model/conventions/clock_hint.h"

#include <gtest/gtest.h>

#include "algorithms/messages/render.h"

namespace remount::conventions {
namespace {

constexpr std::int64_t kSecond = 1'000'000'000, kNow = 1'700'000'000 * kSecond;

std::string apart(double lidar_later_s, double length_s = 10.0) {
  const auto shift = static_cast<std::int64_t>(lidar_later_s * 1e9), length = static_cast<std::int64_t>(length_s * 1e9);
  return english(time_spans_apart({kNow + shift, kNow + shift + length}, {kNow, kNow + length}));
}

TEST(clock_hint, says_by_how_much_and_why) {
  EXPECT_NE(apart(18.0).find("begin 8.000 s after the INS data end"), std::string::npos) << apart(18.0);
  EXPECT_NE(apart(-18.0).find("end 8.000 s before the INS data begin"), std::string::npos) << apart(-18.0);
  for (const double leap : {18.0, -18.0, 17.0})
    EXPECT_NE(apart(leap).find("leap seconds"), std::string::npos) << apart(leap);
  for (const double zone : {3600.0, -7200.3, 5.5 * 3600.0})
    EXPECT_NE(apart(zone).find("time zone"), std::string::npos) << apart(zone);
  for (const double other : {60.0, 100.0, 400.0})
    EXPECT_EQ(apart(other, 0.8 * other).find("leap"), std::string::npos) << apart(other, 0.8 * other);
  EXPECT_NE(apart(7200.0).find("about 2 h:"), std::string::npos) << apart(7200.0);
  EXPECT_NE(apart(-315964782.0).find("1980"), std::string::npos) << apart(-315964782.0);
  for (const double other : {500.0, 1e6, -1.6e9}) {
    EXPECT_NE(apart(other).find("different drives"), std::string::npos) << apart(other);
    EXPECT_EQ(apart(other).find("time zone"), std::string::npos) << apart(other);
  }
}

std::string cause(std::int64_t lidar_ns, std::int64_t other_ns, double apart_s) {
  return english(cause_of_apart_clocks(lidar_ns, other_ns, apart_s));
}

TEST(clock_hint, names_what_is_known_to_keep_clocks_of_one_recording_apart) {
  EXPECT_NE(cause(kNow, kNow, 28800.02).find("about 8 h: likely a time zone"), std::string::npos);
  EXPECT_NE(cause(kNow, kNow, -17.98).find("leap seconds"), std::string::npos);
  EXPECT_NE(cause(5000 * kSecond, kNow, 1.7e9).find("The LiDAR's clock counts from"), std::string::npos);
  EXPECT_NE(cause(kNow, 5000 * kSecond, -1.7e9).find("That clock counts from"), std::string::npos);
  for (const double other_s : {1.8, -0.7, 12.0, 5000.0}) EXPECT_EQ(cause(kNow, kNow, other_s), "");
}

std::string shifted(double begins_s, double ends_s) {
  const auto ns = [](double seconds) { return static_cast<std::int64_t>(seconds * 1e9); };
  return english(
      shifted_by_leap_seconds({kNow + ns(begins_s), kNow + 60 * kSecond + ns(ends_s)}, {kNow, kNow + 60 * kSecond}));
}

TEST(clock_hint, ends_that_differ_by_leap_seconds_alike_are_suspected) {
  EXPECT_NE(shifted(-18.0, -18.0).find("GPS time is 18 s ahead of UTC"), std::string::npos) << shifted(-18.0, -18.0);
  EXPECT_NE(shifted(-18.0, -18.0).find("begin 18.000 s before"), std::string::npos) << shifted(-18.0, -18.0);
  EXPECT_NE(shifted(17.2, 18.4).find("GPS time"), std::string::npos);
  EXPECT_NE(shifted(37.3, 36.9).find("TAI is 37 s"), std::string::npos);
  EXPECT_NE(shifted(-20.0, -20.1).find("TAI is 19 s"), std::string::npos);
  for (const auto& [begins_s, ends_s] :
       {std::pair(0.5, -0.5), std::pair(18.0, -18.0), std::pair(18.0, 0.0), std::pair(0.0, 18.0), std::pair(25.0, 25.0),
        std::pair(-10.0, -10.0), std::pair(18.0, 30.0)})
    EXPECT_EQ(shifted(begins_s, ends_s), "") << begins_s << " " << ends_s;
}

std::string leap_seconds(double difference_s, double slack_s) {
  return english(leap_second_hint(difference_s, slack_s));
}

// Recorders that were started a second apart hide which of two time scales it is.
TEST(clock_hint, time_scales_that_cannot_be_told_apart_are_both_named) {
  for (const double difference_s : {17.5, 18.4, 19.0, 20.4}) {
    const std::string hint = leap_seconds(difference_s, 3.0);
    EXPECT_NE(hint.find("GPS time is 18 s ahead of UTC"), std::string::npos) << difference_s << hint;
    EXPECT_NE(hint.find("TAI 19 s ahead of GPS time"), std::string::npos) << difference_s << hint;
  }
  EXPECT_EQ(leap_seconds(18.0, 0.5).find("TAI"), std::string::npos);
  EXPECT_EQ(leap_seconds(-19.0, 0.5).find("UTC"), std::string::npos);
  EXPECT_NE(leap_seconds(-36.8, 0.5).find("TAI is 37 s"), std::string::npos);
  EXPECT_EQ(leap_seconds(23.0, 3.0), "");
}

}  // namespace
}  // namespace remount::conventions
