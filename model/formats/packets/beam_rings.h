// Rings of beams that look up and down.
#pragma once

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <vector>

namespace remount::formats {

/// The ring of each beam: 0 is the lowest. Beams of one elevation have rings in their order. @param elevations in any
/// unit
inline std::vector<std::uint16_t> rings_of(const std::vector<double>& elevations) {
  std::vector<std::size_t> by_elevation(elevations.size());
  std::iota(by_elevation.begin(), by_elevation.end(), std::size_t{0});
  std::ranges::stable_sort(by_elevation, {}, [&](std::size_t beam) { return elevations[beam]; });
  std::vector<std::uint16_t> rings(elevations.size());
  for (std::size_t ring = 0; ring < rings.size(); ++ring) rings[by_elevation[ring]] = static_cast<std::uint16_t>(ring);
  return rings;
}

}  // namespace remount::formats
