// LAS files as the standard says, byte by byte.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <string>
#include <vector>

namespace remount::formats {

template <class T>
inline void put(std::string& bytes, std::size_t at, T value) {
  if (bytes.size() < at + sizeof(T)) bytes.resize(at + sizeof(T), '\0');
  std::memcpy(bytes.data() + at, &value, sizeof(T));
}

struct LasOptions {
  int minor = 2;
  int format = 1;
  bool whole_gps_time = true;
  std::vector<Eigen::Vector3d> points{{1, 2, 3}, {-4, 5.001, -6}};
  std::vector<double> times{};  ///< as long as the points, or empty
  double offset_m = 0.0;
  int extra_bytes = 0;
};

/// A file as the standard says, with a variable-length record between header and points.
inline std::string las(const LasOptions& options) {
  constexpr std::array<std::size_t, 11> kBytes{20, 28, 26, 34, 57, 63, 30, 36, 38, 59, 67};
  const std::size_t header = options.minor == 4 ? 375 : options.minor == 3 ? 235 : 227;
  const auto format = static_cast<std::size_t>(options.format);
  const std::size_t points_at = header + 54 + 10,
                    record = kBytes[format] + static_cast<std::size_t>(options.extra_bytes);
  std::string bytes(points_at, '\0');
  std::memcpy(bytes.data(), "LASF", 4);
  put(bytes, 6, static_cast<std::uint16_t>(options.whole_gps_time ? 1 : 0));
  put(bytes, 24, std::uint8_t{1}), put(bytes, 25, static_cast<std::uint8_t>(options.minor));
  put(bytes, 94, static_cast<std::uint16_t>(header)), put(bytes, 96, static_cast<std::uint32_t>(points_at));
  put(bytes, 104, static_cast<std::uint8_t>(format)), put(bytes, 105, static_cast<std::uint16_t>(record));
  const auto count = static_cast<std::uint32_t>(options.points.size());
  if (options.minor == 4)
    put(bytes, 247, std::uint64_t{count});
  else
    put(bytes, 107, count);
  for (std::size_t axis = 0; axis < 3; ++axis)
    put(bytes, 131 + 8 * axis, 0.001), put(bytes, 155 + 8 * axis, options.offset_m);
  for (std::size_t i = 0; i < options.points.size(); ++i) {
    const std::size_t at = points_at + i * record;
    bytes.resize(at + record, '\0');
    for (std::size_t axis = 0; axis < 3; ++axis)
      put(bytes, at + 4 * axis,
          static_cast<std::int32_t>(
              std::llround((options.points[i][static_cast<Eigen::Index>(axis)] - options.offset_m) * 1000.0)));
    put(bytes, at + 12, static_cast<std::uint16_t>(100 + i));
    if (!options.times.empty()) put(bytes, at + (format < 6 ? 20 : 22), options.times[i]);
  }
  return bytes;
}

}  // namespace remount::formats
