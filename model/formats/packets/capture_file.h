// The UDP datagrams of a capture of network packets.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "algorithms/core/progress.h"
#include "model/drive/finding.h"
#include "model/formats/files/random_access_file.h"
#include "model/formats/packets/fragments.h"
#include "model/formats/packets/frames.h"

namespace remount::formats {

/// A datagram as it is met on the way through the file.
struct Datagram {
  DatagramRoute route;
  std::int64_t time_ns = 0;           ///< Unix time of the host that captured it
  std::string_view payload;           ///< behind the header of UDP; until the next is met
  std::vector<DatagramPiece> pieces;  ///< of the payload in the file; one where it was not cut
};

/// What is to be known of a capture beside its datagrams.
struct CaptureCounts {
  std::size_t frames = 0;      ///< all of them
  std::size_t datagrams = 0;   ///< whole ones, of UDP over IPv4
  std::size_t truncated = 0;   ///< whose ends were not captured
  std::size_t incomplete = 0;  ///< of which fragments are missing
  std::size_t unknown_link = 0;
  std::size_t broken_frames = 0;   ///< of a recording of Livox Viewer: behind what is no package they are not used
  std::uint64_t unread_bytes = 0;  ///< at the end of the file
  bool cut = false;                ///< the file ends within a frame; otherwise what is unread is damaged
};

/// Goes through the file once, in its order. Ends early where `progress` is cancelled or `most_bytes` have been read.
/// Throws Error as read_records does, and Error(Io).
CaptureCounts visit_datagrams(const RandomAccessFile& file, const std::function<void(const Datagram&)>& take,
                              Progress& progress, std::uint64_t most_bytes = ~std::uint64_t{0});

/// The payload of a datagram that was met before. Thread-safe. Throws Error as RandomAccessFile does.
std::string read_payload(const RandomAccessFile& file, const DatagramPiece* pieces, std::size_t count);

/// Adds "capture-cut", "capture-truncated", "capture-fragments" and "lvx-frames" where there is something to say.
void report_counts(const CaptureCounts& counts, const std::string& where, std::vector<drive::Finding>& findings);

}  // namespace remount::formats
