// Where the packets of each LiDAR stand in a capture: made in one pass, so that scans are read when they are asked for.
//
// A value: an index that was kept beside the cache would take the place of index_capture().
#pragma once

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "algorithms/core/error.h"
#include "model/formats/packets/capture_file.h"
#include "model/formats/packets/packet_decoder.h"

namespace remount::formats {

struct IndexedPacket {
  std::int64_t host_ns = 0;  ///< when the host captured it, Unix time
  std::int64_t time_ns = 0;  ///< of the first column: by the sensor's clock, and Unix time once that is settled
  std::uint64_t offset = 0;  ///< of the payload in the file; of a datagram in pieces, the place of the first of them
  std::uint32_t bytes = 0;
  std::uint32_t first_place = 0, last_place = 0, cut_after_ns = 0, frame = 0;  ///< see PacketGlance
  std::uint16_t cut_column = 0;
  std::uint16_t pieces = 1;
  std::uint16_t clock_period_s = 0;            ///< see PacketGlance
  SecondPart second_part = SecondPart::Known;  ///< see PacketGlance
};

/// What a glance tells of a packet of so many bytes; when it was captured and where it stands come to it.
IndexedPacket indexed_packet(const PacketGlance& glance, std::size_t bytes);

/// What one sensor sent.
struct SensorPackets {
  DatagramRoute route;
  std::string name;  ///< of a sensor in a file that has no routes
  std::shared_ptr<PacketDecoder> decoder;
  std::vector<IndexedPacket> packets;  ///< in the order of the file
  std::vector<DatagramPiece> pieces;   ///< of those that were cut by the network
  std::size_t foreign = 0;             ///< datagrams that are no packets of points of any sensor
  std::size_t of_others = 0;           ///< packets of points of other sensors of this address and port
};

/// Counts what is no packet of points of this sensor, unless its decoder passes over it without a word.
void count_unused(SensorPackets& sensor, std::string_view payload);

/// "192.168.1.201:2368", or its name.
std::string name_of(const SensorPackets& sensor);

/// The receiver that a sensor hangs on, as its packets tell of it.
struct SensorReceiver {
  struct State {
    std::int64_t host_ns = 0;
    bool clock_locked = false;
  };
  std::vector<State> states;
  std::string sentences;  ///< each once
};

struct CaptureIndex {
  std::shared_ptr<const RandomAccessFile> file;
  CaptureCounts counts;
  std::vector<SensorPackets> sensors;                         ///< by address and port
  std::map<std::uint32_t, SensorReceiver> receivers;          ///< by the address of the sensor
  std::vector<std::pair<DatagramRoute, std::size_t>> others;  ///< routes of other datagrams, and how many these are
  std::vector<Error> refused;                                 ///< sensors of a known make that are not decoded
};

/// Of a capture of a network, or a recording of Livox Viewer. Throws Error as visit_datagrams and index_lvx do. Where
/// `progress` is cancelled, of what was read so far.
CaptureIndex index_capture(const std::filesystem::path& path, Progress& progress);

/// The sensors whose packets are among the first megabytes of a file, with those. Throws Error as index_capture does.
std::vector<SensorPackets> sensors_at_begin(const std::filesystem::path& path);
/// Whether there are any, also of those that are not decoded. Never throws.
bool holds_lidar(const std::filesystem::path& path);

}  // namespace remount::formats
