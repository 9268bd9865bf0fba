#include "model/clock_hint.h"

#include <gtest/gtest.h>

namespace remount {
namespace {

constexpr std::int64_t kSecond = 1'000'000'000, kNow = 1'700'000'000 * kSecond;

std::string apart(double lidar_later_s, double length_s = 10.0) {
  const auto shift = static_cast<std::int64_t>(lidar_later_s * 1e9), length = static_cast<std::int64_t>(length_s * 1e9);
  return time_spans_apart({kNow + shift, kNow + shift + length}, {kNow, kNow + length});
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
  EXPECT_NE(apart(7200.0).find("about 2 hours"), std::string::npos) << apart(7200.0);
  EXPECT_NE(apart(-315964782.0).find("1980"), std::string::npos) << apart(-315964782.0);
  for (const double other : {500.0, 1e6, -1.6e9}) {
    EXPECT_NE(apart(other).find("different drives"), std::string::npos) << apart(other);
    EXPECT_EQ(apart(other).find("time zone"), std::string::npos) << apart(other);
  }
}

}  // namespace
}  // namespace remount
