#include "model/formats/ins/angle_unit_check.h"

#include <gtest/gtest.h>

#include <cmath>

#include "algorithms/geometry/rotation.h"
#include "algorithms/messages/render.h"
#include "tests/model/formats/temporary_folder.h"

namespace remount::formats {
namespace {

/// A drive near 48 N at 10 m/s whose heading is `heading_deg(t)` from east counter-clockwise, with the angles logged in
/// degrees times `factor`, and a sensor turned by `mounted_deg` against the vehicle.
struct Log {
  std::vector<motion::InsSample> samples;
  std::vector<drive::AttitudeAngles> logged;
  std::vector<drive::Finding> findings;

  template <class Heading>
  Log(Heading&& heading_deg, double factor, double tilt_deg = 0.5, double mounted_deg = 0.0, double speed_mps = 10.0) {
    double north_m = 0.0, east_m = 0.0;
    for (int i = 0; i < 600; ++i) {
      const double t = 0.1 * i, course_rad = degrees_to_radians(heading_deg(t));
      motion::InsSample sample;
      sample.stamp_ns = i * 100'000'000LL;
      sample.latitude_rad = 0.84 + north_m / 6371000.0;
      sample.longitude_rad = 0.16 + east_m / 6371000.0 / std::cos(0.84);
      samples.push_back(sample);
      const double yaw_deg = radians_to_degrees(wrap_angle_rad(course_rad)) + mounted_deg;
      logged.push_back({yaw_deg * factor, tilt_deg * factor, -tilt_deg * factor});
      north_m += 0.1 * speed_mps * std::sin(course_rad);
      east_m += 0.1 * speed_mps * std::cos(course_rad);
    }
  }
  void check(double unit_rad) {
    check_angle_unit(samples, logged, unit_rad, drive::AttitudeConvention::EnuYaw, "ins.csv", findings);
  }
};

constexpr double kDegree = kPi / 180.0, kRadian = 1.0;

double winding(double t) { return 30.0 + 80.0 * std::sin(0.2 * t); }
double circling(double t) { return 12.0 * t; }
double straight(double) { return 40.0; }

TEST(angle_unit, right_units_pass_without_a_word) {
  for (const auto& heading : {winding, circling, straight})
    for (const double mounted_deg : {0.0, 90.0, 180.0}) {
      Log degrees(heading, 1.0, 0.5, mounted_deg), radians(heading, kDegree, 0.5, mounted_deg);
      degrees.check(kDegree);
      radians.check(kRadian);
      EXPECT_TRUE(degrees.findings.empty()) << mounted_deg << ": " << english(degrees.findings[0].explanation);
      EXPECT_TRUE(radians.findings.empty()) << mounted_deg << ": " << english(radians.findings[0].explanation);
    }
}

TEST(angle_unit, degrees_declared_as_radians_are_refused_with_what_to_declare) {
  for (const auto& heading : {winding, circling}) {
    Log log(heading, 1.0);
    EXPECT_ERROR(log.check(kRadian), "ins.csv: the angles are declared as unit: rad");
    EXPECT_ERROR(log.check(kRadian), "{unit: deg} in session.yaml");
  }
  Log tilted(straight, 1.0, 5.0);
  EXPECT_ERROR(tilted.check(kRadian), "roll or pitch reaches 5, more than radians allow");
}

TEST(angle_unit, radians_declared_as_degrees_are_refused_with_what_to_declare) {
  for (const auto& heading : {winding, circling}) {
    Log log(heading, kDegree);
    EXPECT_ERROR(log.check(kDegree), "the angles are declared as unit: deg");
    EXPECT_ERROR(log.check(kDegree), "{unit: rad} in session.yaml");
  }
}

double bend(double t) { return 10.0 + 0.5 * t; }

TEST(angle_unit, angles_that_were_converted_once_too_often_are_refused_with_how_much) {
  for (const auto& heading : {winding, circling, bend}) {
    Log smaller(heading, kDegree * kDegree), larger(heading, 1.0 / kDegree), radians(heading, kDegree * kDegree);
    EXPECT_ERROR(smaller.check(kDegree), "3283 times larger");
    EXPECT_ERROR(larger.check(kDegree), "57.3 times smaller: they were converted once too often");
    EXPECT_ERROR(radians.check(kRadian), "57.3 times larger");
  }
}

TEST(angle_unit, a_gentle_bend_tells_radians_from_degrees) {
  Log radians(bend, kDegree), degrees(bend, 1.0), right(bend, 1.0);
  EXPECT_ERROR(radians.check(kDegree), "{unit: rad} in session.yaml");
  EXPECT_ERROR(degrees.check(kRadian), "{unit: deg} in session.yaml");
  right.check(kDegree);
  EXPECT_TRUE(right.findings.empty());
}

TEST(angle_unit, on_a_straight_road_the_other_unit_is_suspected) {
  for (const auto& [factor, unit] : {std::pair(1.0, kRadian), std::pair(kDegree, kDegree)}) {
    Log log(straight, factor);
    log.check(unit);
    ASSERT_EQ(log.findings.size(), 1U);
    EXPECT_EQ(log.findings[0].code, "angle-unit");
    EXPECT_EQ(log.findings[0].severity, drive::Severity::Problem);
  }
}

TEST(angle_unit, a_few_glitches_and_a_vehicle_that_stands_say_nothing) {
  Log glitches(winding, kDegree);
  glitches.logged[5].roll_rad = 1e6;
  glitches.check(kRadian);
  EXPECT_TRUE(glitches.findings.empty());
  Log standing(winding, 1.0, 0.5, 0.0, 0.0);
  standing.check(kRadian);
  EXPECT_TRUE(standing.findings.empty()) << "nothing is known of a vehicle that stands";
}

}  // namespace
}  // namespace remount::formats
