#include "model/formats/ins/place_unit.h"

#include <gtest/gtest.h>

#include "algorithms/geometry/rotation.h"

namespace remount::formats {
namespace {

TEST(place_unit, every_unit_gives_the_angle) {
  EXPECT_DOUBLE_EQ(radians_to_degrees(place_rad(48.1173, PlaceUnit::Degrees)), 48.1173);
  EXPECT_DOUBLE_EQ(place_rad(0.84, PlaceUnit::Radians), 0.84);
  EXPECT_NEAR(radians_to_degrees(place_rad(481'173'000.0, PlaceUnit::TenMillionths)), 48.1173, 1e-12);
  EXPECT_NEAR(radians_to_degrees(place_rad(4807.038, PlaceUnit::DegreesMinutes)), 48.1173, 1e-12);
  EXPECT_NEAR(radians_to_degrees(place_rad(-1131.0, PlaceUnit::DegreesMinutes)), -(11.0 + 31.0 / 60.0), 1e-12);
  EXPECT_NEAR(radians_to_degrees(place_rad(-30.0, PlaceUnit::DegreesMinutes)), -0.5, 1e-12) << "south of the equator";
  EXPECT_TRUE(std::isnan(place_rad(4860.0, PlaceUnit::DegreesMinutes)));
}

TEST(place_unit, every_unit_has_a_name_of_its_own) {
  for (const auto& [unit, name] : kPlaceUnits) {
    EXPECT_EQ(to_string(unit), name);
    EXPECT_EQ(place_unit_named(name), unit);
  }
  EXPECT_FALSE(place_unit_named("gon"));
}

}  // namespace
}  // namespace remount::formats
