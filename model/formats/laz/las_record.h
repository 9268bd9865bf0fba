// A point of a LAS file, as far as scans need it.
#pragma once

#include <array>
#include <cstdint>
#include <functional>

namespace remount::formats {

struct LasRecord {
  std::array<std::int32_t, 3> xyz{};  ///< in steps of the file's scale, from its offset on
  std::uint16_t intensity = 0;
  double time = 0.0;  ///< GPS time as the file counts it; 0 where it has none
};

using TakeRecord = std::function<void(const LasRecord&)>;

}  // namespace remount::formats
