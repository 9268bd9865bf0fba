// Points as Livox's sensors send them, by the numbers that their protocols give the layouts.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <optional>
#include <string_view>

namespace remount::formats {

/// One shot of a laser. Several returns of it follow each other; of angles, which they share, ranges do.
struct LivoxPointLayout {
  enum class Coordinates { Millimetres, Centimetres, Metres, Spherical };
  Coordinates coordinates = Coordinates::Millimetres;
  std::size_t bytes = 0;  ///< of a shot
  std::size_t returns = 1;
};

/// Of the first SDK (Mid-40, Mid-70, Horizon, Tele, Avia), and of the second (Mid-360, HAP). Nothing for what is not of
/// points.
std::optional<LivoxPointLayout> livox_layout_of_sdk1(std::uint8_t data_type);
std::optional<LivoxPointLayout> livox_layout_of_sdk2(std::uint8_t data_type);
/// Of recordings of Livox Viewer before it kept packets as they were sent.
inline constexpr LivoxPointLayout kLivoxFloatPoints{LivoxPointLayout::Coordinates::Metres, 13, 1};
/// How many shots of a layout a packet of the first SDK has.
std::size_t livox_shots_of_sdk1(const LivoxPointLayout& layout);

struct LivoxReturn {
  Eigen::Vector3d point_m = Eigen::Vector3d::Zero();  ///< zero where nothing came back; x ahead, y left, z up
  std::uint8_t reflectivity = 0;
};

/// @param shot as many bytes as the layout says
LivoxReturn livox_return(const LivoxPointLayout& layout, std::string_view shot, std::size_t which);

}  // namespace remount::formats
