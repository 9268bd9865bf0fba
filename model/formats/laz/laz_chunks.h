// The points of one chunk of a compressed LAS file.
#pragma once

#include <string>
#include <string_view>

#include "model/formats/laz/las_record.h"
#include "model/formats/laz/laz_layout.h"

namespace remount::formats {

/// One chunk: its bytes, at least those of a point, and how many points are in it, at least one.
struct ChunkBytes {
  std::string_view bytes;
  std::size_t points = 0;
  std::string where;  ///< for messages
};

/// Of point formats 0 to 5: one stream with all parts of a point behind each other. Colours, wave packets and extra
/// bytes are passed over. Throws Error(Format) at `where`.
void unpack_point_wise(const ChunkBytes& chunk, const LazLayout& layout, const TakeRecord& take);

/// Of point formats 6 to 10: a stream for each part of a point, of which four are read. Throws Error(Format) at
/// `where`.
void unpack_layered(const ChunkBytes& chunk, const LazLayout& layout, const TakeRecord& take);

}  // namespace remount::formats
