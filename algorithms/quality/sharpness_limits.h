// What counts as a difference between the sharpness of two maps.
#pragma once

#include <cstddef>

namespace remount::quality {

/// Ratio of thicknesses below which it is chance: neighbourhoods are few, and the noise of the INS blurs every map.
inline constexpr double kClearlySharper = 1.05;
/// Fewer neighbourhoods than this are one wall, or chance.
inline constexpr std::size_t kFewestPlaces = 200;

}  // namespace remount::quality
