#include "model/formats/laz/laz_points.h"

#include "model/formats/laz/laz_chunks.h"

namespace remount::formats {

void unpack_laz(const LazFile& file, const TakeRecord& take) {
  const LazLayout layout = read_laz_layout(file);
  for (std::size_t i = 0; i < layout.chunks.size(); ++i) {
    const LazChunk& chunk = layout.chunks[i];
    const ChunkBytes bytes{file.bytes.substr(chunk.at, chunk.bytes), chunk.points,
                           file.path + ", byte " + std::to_string(chunk.at) + " (chunk " + std::to_string(i) + ")"};
    (layout.layered ? unpack_layered : unpack_point_wise)(bytes, layout, take);
  }
}

}  // namespace remount::formats
