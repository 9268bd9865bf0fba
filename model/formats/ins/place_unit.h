// What the numbers of latitudes and longitudes count.
#pragma once

#include <array>
#include <cmath>
#include <optional>
#include <string_view>
#include <utility>

#include "algorithms/geometry/degree.h"

namespace remount::formats {

enum class PlaceUnit {
  Degrees,
  Radians,
  TenMillionths,   ///< of a degree, as whole numbers
  DegreesMinutes,  ///< 4807.038 is 48 degrees and 7.038 minutes, as in NMEA
};

/// In the order in which forms offer them, with how a manifest writes them.
inline constexpr std::array<std::pair<PlaceUnit, std::string_view>, 4> kPlaceUnits{
    {{PlaceUnit::Degrees, "deg"},
     {PlaceUnit::Radians, "rad"},
     {PlaceUnit::DegreesMinutes, "ddmm"},
     {PlaceUnit::TenMillionths, "1e-7deg"}}};

inline std::string_view to_string(PlaceUnit unit) {
  for (const auto& [one, name] : kPlaceUnits)
    if (one == unit) return name;
  return {};
}

/// Nothing where the name is none of these.
inline std::optional<PlaceUnit> place_unit_named(std::string_view name) {
  for (const auto& [one, known] : kPlaceUnits)
    if (known == name) return one;
  return std::nullopt;
}

/// 7.038 of 4807.038, whatever the sign.
inline double minutes_of_place(double number) { return std::fmod(std::abs(number), 100.0); }

/// The angle of a number, south and west negative as the number is. Of degrees and minutes not a number where the
/// minutes are 60 or more: it is none then.
inline double place_rad(double number, PlaceUnit unit) {
  constexpr double kTenMillionth = 1e-7;
  switch (unit) {
    case PlaceUnit::Radians:
      return number;
    case PlaceUnit::TenMillionths:
      return number * kTenMillionth * kDegree_rad;
    case PlaceUnit::DegreesMinutes: {
      const double minutes = minutes_of_place(number), degrees = (std::abs(number) - minutes) / 100.0;
      return minutes < 60.0 ? std::copysign(degrees + minutes / 60.0, number) * kDegree_rad : std::nan("");
    }
    default:
      return number * kDegree_rad;
  }
}

}  // namespace remount::formats
