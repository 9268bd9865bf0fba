#include "model/guesses/column_names.h"

#include <gtest/gtest.h>

namespace remount::guesses {
namespace {

struct Title {
  const char* title;
  Quantity quantity;
  const char* unit;
};

TEST(column_names, makers_and_people_call_columns_by_many_names) {
  for (const Title& one : {Title{"Latitude (deg)", Quantity::Latitude, "deg"},
                           {"lat_rad", Quantity::Latitude, "rad"},
                           {"纬度(度)", Quantity::Latitude, "deg"},
                           {"经度", Quantity::Longitude, ""},
                           {"高程（米）", Quantity::Height, "m"},
                           {"航向角[度]", Quantity::Heading, "deg"},
                           {"俯仰角", Quantity::Pitch, ""},
                           {"横滚角", Quantity::Roll, ""},
                           {"GPS周内秒", Quantity::WeekSeconds, ""},
                           {"H-Ell", Quantity::Height, ""},
                           {"ELLIPSOID HEIGHT", Quantity::Height, ""},
                           {"PosLon (deg)", Quantity::Longitude, "deg"},
                           {"AngleHeading(deg)", Quantity::Heading, "deg"},
                           {"Quat_q0", Quantity::Qw, ""},
                           {"field.pose.pose.position.x", Quantity::X, ""},
                           {"field.pose.pose.orientation.w", Quantity::Qw, ""},
                           {"field.header.stamp.nsecs", Quantity::Nanoseconds, ""},
                           {"field.header.stamp.secs", Quantity::Seconds, ""},
                           {"time_ns", Quantity::Time, "ns"},
                           {"timestamp [us]", Quantity::Time, "us"},
                           {"TOW(s)", Quantity::WeekSeconds, "s"},
                           {"east velocity", Quantity::Other, ""},
                           {"yaw_rate (deg/s)", Quantity::Other, "deg/s"},
                           {"东向速度", Quantity::Other, ""},
                           {"v_east", Quantity::Other, ""},
                           {"vn", Quantity::Other, ""},
                           {"北速", Quantity::Other, ""},
                           {"SDHeight", Quantity::SigmaUp, ""},
                           {"track angle", Quantity::Course, ""}}) {
    const auto found = quantity_of(one.title);
    ASSERT_TRUE(found) << one.title;
    EXPECT_EQ(found->quantity, one.quantity) << one.title;
    EXPECT_EQ(found->unit, one.unit) << one.title;
  }
  for (const char* title : {"", "satellites", "pdop", "(deg)", "3"}) EXPECT_FALSE(quantity_of(title)) << title;
  EXPECT_EQ(quantity_of("Roll", "(rad)")->unit, "rad") << "of a line below";
}

TEST(column_names, units_are_told_without_a_name_that_is_known) {
  EXPECT_EQ(unit_stated("TOW [0.001 s]"), "ms");
  EXPECT_EQ(unit_stated("UTC Microseconds"), "us");
  for (const auto& [title, unit] : {std::pair("angle3 [rad]", "rad"),
                                    {"foo_deg", "deg"},
                                    {"speed (km/h)", "km/h"},
                                    {"stamp.nsecs", "ns"},
                                    {"lat_rad", "rad"},
                                    {"foo", ""},
                                    {"x", ""}})
    EXPECT_EQ(unit_stated(title), unit) << title;
  EXPECT_EQ(unit_stated("foo", "(ms)"), "ms");
}

}  // namespace
}  // namespace remount::guesses
