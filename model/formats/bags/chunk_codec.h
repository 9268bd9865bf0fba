// Chunks of bags are compressed as a whole: bzip2 (ROS 1), LZ4 frames (ROS 1, MCAP), Zstandard (MCAP, ROS 2).
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>

namespace remount::bags {

enum class ChunkCompression { None, Bzip2, Lz4, Zstd };

/// Of a name as bags write it: "none" and "", "bz2", "lz4", "zstd". Throws Error(Unsupported) at `where` for others.
ChunkCompression chunk_compression(std::string_view name, const std::string& where);

enum class ChunkEnd {
  Whole,  ///< anything but `size` bytes is an error
  Cut,    ///< the file ends within the chunk: as much as can be unpacked
  Early,  ///< fewer than `size` bytes are right where the packed data end, and an error where they are damaged
};

enum class UnpackStep {
  More,
  Done,    ///< the packed data end here
  Broken,  ///< they are damaged, or cut
};

/// Unpacks piece by piece.
class Unpacker {
 public:
  virtual ~Unpacker() = default;
  /// Fills up to `room` bytes from `to` on: takes what it has read off the beginning of `packed`, and says in `room`
  /// how much it wrote. Where it neither reads nor writes it wants more to read.
  virtual UnpackStep step(std::string_view& packed, char* to, std::size_t& room) = 0;
};
/// Throws Error(Contract) for None.
std::unique_ptr<Unpacker> make_unpacker(ChunkCompression compression);

/// Unpacks up to `size` bytes, and takes memory for no more than these: it is for the caller to see that they are not
/// too many. Bytes after the packed data are left alone. Throws Error(Format) at `where`.
std::string unpack_chunk(ChunkCompression compression, std::string_view packed, std::uint64_t size, ChunkEnd end,
                         const std::string& where);

/// The inverse.
std::string pack_chunk(ChunkCompression compression, std::string_view bytes);

}  // namespace remount::bags
