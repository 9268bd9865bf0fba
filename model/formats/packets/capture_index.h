// The packets of each LiDAR in a capture.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "algorithms/core/progress.h"
#include "model/formats/packets/index_store.h"
#include "model/formats/packets/packet_index.h"

namespace remount::formats {

/// Of a capture of a network, or a recording of Livox Viewer. Throws Error as visit_datagrams and index_lvx do. Where
/// `progress` is cancelled, of what was read so far. That of a large capture is kept, so that another opening does not
/// read the capture (index_once).
PacketIndex index_capture(const std::filesystem::path& path, Progress& progress,
                          const IndexStore& store = users_index_store());

/// What is captured, read again.
std::shared_ptr<const PacketFile> captured_packets(std::shared_ptr<const RandomAccessFile> file);

/// Of the first megabytes of a file. Throws Error as index_capture does.
PacketIndex index_begin(const std::filesystem::path& path);
/// The sensors whose packets are among these, with those. Throws Error as index_capture does.
std::vector<SensorPackets> sensors_at_begin(const std::filesystem::path& path);
/// Whether there are any, also of those that are not decoded. Never throws.
bool holds_lidar(const std::filesystem::path& path);

}  // namespace remount::formats
