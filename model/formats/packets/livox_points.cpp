#include "model/formats/packets/livox_points.h"

#include <cmath>

#include "algorithms/geometry/rotation.h"
#include "model/formats/files/number_bytes.h"

namespace remount::formats {

namespace {

using Coordinates = LivoxPointLayout::Coordinates;

/// Angles in hundredths of a degree: from straight up, and from ahead to the left.
Eigen::Vector3d spherical_point(double range_m, std::uint16_t zenith, std::uint16_t azimuth) {
  const double down_rad = degrees_to_radians(0.01 * zenith), around_rad = degrees_to_radians(0.01 * azimuth);
  return range_m * Eigen::Vector3d(std::sin(down_rad) * std::cos(around_rad), std::sin(down_rad) * std::sin(around_rad),
                                   std::cos(down_rad));
}

LivoxReturn spherical_return(const LivoxPointLayout& layout, std::string_view shot, std::size_t which) {
  constexpr double kUnit_m = 1e-3;
  // One return has its range in front of the angles; of several, each with a tag, the ranges follow them.
  constexpr std::size_t kReturnsAt = 4, kReturnBytes = 6;
  const bool alone = layout.returns == 1;
  const std::size_t angles_at = alone ? 4 : 0, range_at = alone ? 0 : kReturnsAt + which * kReturnBytes;
  const std::size_t light_at = alone ? 8 : range_at + 4;
  return {
      spherical_point(kUnit_m * little_number<std::uint32_t>(shot, range_at),
                      little_number<std::uint16_t>(shot, angles_at), little_number<std::uint16_t>(shot, angles_at + 2)),
      static_cast<std::uint8_t>(shot[light_at])};
}

template <class Number>
LivoxReturn cartesian_return(std::string_view bytes, double unit_m) {
  const auto coordinate = [&](std::size_t axis) {
    return unit_m * static_cast<double>(little_number<Number>(bytes, axis * sizeof(Number)));
  };
  return {{coordinate(0), coordinate(1), coordinate(2)}, byte_at(bytes, 3 * sizeof(Number))};
}

}  // namespace

std::optional<LivoxPointLayout> livox_layout_of_sdk1(std::uint8_t data_type) {
  switch (data_type) {
    case 0:
      return LivoxPointLayout{Coordinates::Millimetres, 13, 1};
    case 1:
      return LivoxPointLayout{Coordinates::Spherical, 9, 1};
    case 2:
      return LivoxPointLayout{Coordinates::Millimetres, 14, 1};
    case 3:
      return LivoxPointLayout{Coordinates::Spherical, 10, 1};
    case 4:
      return LivoxPointLayout{Coordinates::Millimetres, 28, 2};
    case 5:
      return LivoxPointLayout{Coordinates::Spherical, 16, 2};
    case 7:
      return LivoxPointLayout{Coordinates::Millimetres, 42, 3};
    case 8:
      return LivoxPointLayout{Coordinates::Spherical, 22, 3};
    default:
      return std::nullopt;
  }
}

std::size_t livox_shots_of_sdk1(const LivoxPointLayout& layout) {
  constexpr std::size_t kWithoutTags = 100, kWithTags = 96, kOfTwo = 48, kOfThree = 30;
  if (layout.returns > 1) return layout.returns == 2 ? kOfTwo : kOfThree;
  const bool tags = layout.bytes == 14 || layout.bytes == 10;
  return tags ? kWithTags : kWithoutTags;
}

std::optional<LivoxPointLayout> livox_layout_of_sdk2(std::uint8_t data_type) {
  constexpr std::uint8_t kTwoReturns = 0x11;
  switch (data_type) {
    case 1:
      return LivoxPointLayout{Coordinates::Millimetres, 14, 1};
    case 2:
      return LivoxPointLayout{Coordinates::Centimetres, 8, 1};
    case 3:
      return LivoxPointLayout{Coordinates::Spherical, 10, 1};
    case kTwoReturns:
      return LivoxPointLayout{Coordinates::Millimetres, 28, 2};
    default:
      return std::nullopt;
  }
}

LivoxReturn livox_return(const LivoxPointLayout& layout, std::string_view shot, std::size_t which) {
  if (layout.coordinates == Coordinates::Spherical) return spherical_return(layout, shot, which);
  const std::string_view bytes = shot.substr(which * (layout.bytes / layout.returns));
  switch (layout.coordinates) {
    case Coordinates::Centimetres:
      return cartesian_return<std::int16_t>(bytes, 0.01);
    case Coordinates::Metres:
      return cartesian_return<float>(bytes, 1.0);
    default:
      return cartesian_return<std::int32_t>(bytes, 0.001);
  }
}

}  // namespace remount::formats
