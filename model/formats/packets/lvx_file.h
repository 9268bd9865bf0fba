// Recordings of Livox Viewer: LVX (versions 1.0 and 1.1) and LVX2, which keep the packets of several sensors in frames.
#pragma once

#include <filesystem>
#include <memory>

#include "model/formats/packets/packet_index.h"

namespace remount::formats {

/// From the first bytes. Never throws.
bool is_lvx(const std::filesystem::path& path);

/// Sensors are called by their serial numbers; a recording knows no other clock than theirs. What is damaged ends it:
/// see CaptureCounts. Mountings that it has are not applied. Throws Error(Format) with the place where its head is not
/// whole, and Error(Unsupported) for a version that is not known.
/// @param most_bytes ends early behind so many
PacketIndex index_lvx(std::shared_ptr<const RandomAccessFile> file, Progress& progress,
                      std::uint64_t most_bytes = ~std::uint64_t{0});

}  // namespace remount::formats
