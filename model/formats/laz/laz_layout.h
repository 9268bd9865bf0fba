// What lies where in a compressed LAS file.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace remount::formats {

/// A compressed LAS file, and what its header says, which was checked.
struct LazFile {
  std::string_view bytes;
  std::string path;
  std::size_t header_bytes = 0, header_records = 0;  ///< those of variable length behind the header
  std::size_t points_at = 0, points = 0, record_bytes = 0;
  std::size_t format = 0;  ///< of the points, 0 to 10
};

/// Parts of a point by the numbers that stand for them in files.
enum class LazPart : std::uint16_t {
  Bytes = 0,
  Point10 = 6,
  GpsTime11,
  Rgb12,
  WavePacket13,
  Point14,
  Rgb14,
  RgbNir14,
  WavePacket14,
  Bytes14
};

struct LazItem {
  LazPart part = LazPart::Bytes;
  std::size_t bytes = 0;
};

struct LazChunk {
  std::size_t at = 0, bytes = 0, points = 0;
};

/// How the points are compressed, and in which pieces.
struct LazLayout {
  bool layered = false;        ///< each part of the points of a chunk for itself; else point by point
  std::vector<LazItem> items;  ///< of a point, in their order; together as long as a point
  std::vector<LazChunk> chunks;
};

/// Throws Error(Unsupported) for ways of compressing that are not read, Error(Format) for what cannot be, at path:byte.
LazLayout read_laz_layout(const LazFile& file);

}  // namespace remount::formats
