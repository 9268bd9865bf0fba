// Indexes of large captures that are kept from one opening to the next.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

#include "algorithms/core/progress.h"
#include "model/formats/packets/capture_file.h"
#include "model/formats/packets/packet_index.h"

namespace remount::formats {

/// Where they are kept, and of what. Files of other programs in the folder are left alone.
struct IndexStore {
  std::filesystem::path folder;                           ///< empty: none is kept
  std::uint64_t least_bytes = std::uint64_t{256} << 20U;  ///< of a capture: a smaller one is read in a second
  std::uint64_t most_bytes = std::uint64_t{4} << 30U;     ///< of all indexes: beyond, the longest unused go
};

/// In the user's cache: $XDG_CACHE_HOME/remount/captures, or ~/.cache/remount/captures.
IndexStore users_index_store();

/// The file that keeps the index of a capture.
std::filesystem::path kept_index_file(const std::filesystem::path& capture, const IndexStore& store);

/// The indexing of the whole capture: of an index that is kept and fits the capture and what lies beside it, else of
/// one pass, which is kept then. An index that does not fit is never used, and `remark` says why; so it does where none
/// could be kept. Throws Error as visit_datagrams. Where `progress` is cancelled, of what was read so far.
struct IndexedCapture {
  PacketIndexing indexing;
  CaptureCounts counts;
  Message remark;
};
IndexedCapture index_once(const std::filesystem::path& path, const RandomAccessFile& file, const IndexStore& store,
                          Progress& progress);

}  // namespace remount::formats
