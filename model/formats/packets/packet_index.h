// Where the packets of each LiDAR stand in a recording: made in one pass, so that scans are read when they are asked
// for. What a recording is (a capture of a network, topics of a bag) is known to those who hand the packets on, and to
// the PacketFile that reads them again.
//
// What a pass found is a value (PassedPackets): one that was kept takes the place of the pass (kept_index.h).
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
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
  friend bool operator==(const IndexedPacket&, const IndexedPacket&) = default;
};

/// What a glance tells of a packet of so many bytes; when it was captured and where it stands come to it.
IndexedPacket indexed_packet(const PacketGlance& glance, std::size_t bytes);

/// What one sensor sent.
struct SensorPackets {
  DatagramRoute route;
  std::string name;  ///< of a sensor in a file that has no routes
  std::shared_ptr<PacketDecoder> decoder;
  std::vector<IndexedPacket> packets;  ///< in the order of the recording
  std::vector<DatagramPiece> pieces;   ///< of those that were cut by the network
  std::size_t foreign = 0;             ///< datagrams that are no packets of points of any sensor
  std::size_t of_others = 0;           ///< packets of points of other sensors of this address and port
};

/// Counts what is no packet of points of this sensor, unless its decoder passes over it without a word.
void count_unused(SensorPackets& sensor, std::string_view payload);

/// "192.168.1.201:2368", the topic, or its name.
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

/// Reads packets again that are in an index. Thread-safe.
class PacketFile {
 public:
  virtual ~PacketFile() = default;
  virtual std::filesystem::path name() const = 0;  ///< for messages
  /// Hands on the payloads of packets [first, last] of a sensor, one after the other. Throws Error where one cannot be
  /// read.
  virtual void read(const SensorPackets& sensor, std::size_t first, std::size_t last,
                    const std::function<void(std::size_t packet, std::string payload)>& take) const = 0;
};

/// What came from one place, to one port.
struct RoutePackets {
  SensorPackets sensor;
  std::vector<DatagramPiece> told_by;  ///< the packet by which the sensor was recognised or, so far, refused
  std::size_t others = 0;              ///< datagrams before that
  bool positions = false;
  bool given_up = false;  ///< what lies beside the recording does not change
  std::optional<Error> refused;
};

/// All that one pass through a recording finds.
struct PassedPackets {
  std::map<DatagramRoute, RoutePackets> routes;
  std::map<std::uint32_t, SensorReceiver> receivers;  ///< by the address of the sensor
  /// Likewise. Of those that have the same lasting part the first.
  std::map<std::uint32_t, std::vector<PositionPacket>> descriptions;
};

struct PacketIndex {
  std::shared_ptr<const PacketFile> file;
  CaptureCounts counts;
  std::vector<SensorPackets> sensors;                         ///< by address and port
  std::map<std::uint32_t, SensorReceiver> receivers;          ///< by the address of the sensor
  std::vector<std::pair<DatagramRoute, std::size_t>> others;  ///< routes of other datagrams, and how many these are
  std::vector<Error> refused;                                 ///< sensors of a known make that are not decoded
  Message remark;  ///< on the index that is kept of the recording; empty: there is nothing to say
};

/// Which sensor a packet of points is of.
struct PacketMake {
  std::string model;             ///< empty: it is not known, but the make
  std::optional<Error> refused;  ///< why it is not decoded: it cannot be, or something is missing beside
  std::shared_ptr<PacketDecoder> decoder = nullptr;  ///< that has looked beside; null: it is refused
};
/// By the makes that are known. Nothing where it is no packet of points of any.
std::optional<PacketMake> make_of_packet(std::string_view payload, const BesidePackets& beside,
                                         const std::string& where);

/// Adds what the sensor says of itself, if it does and nothing with the same lasting part has been taken: of these the
/// first counts. False once there are so many that no more are taken.
bool take_description(const PositionPacket& position, std::vector<PositionPacket>& descriptions);
/// For PacketDecoder::describe.
std::vector<std::string> texts_of(const std::vector<PositionPacket>& descriptions);

/// Takes the packets of a recording in its order, and sorts them by where they come from.
class PacketIndexing {
 public:
  /// @param recording whose files beside it tell of sensors @param said likewise, in the recording itself
  explicit PacketIndexing(std::filesystem::path recording, SaidInRecording said = nullptr);

  void take(const Datagram& datagram);
  /// What was found so far; of no use once it is made().
  const PassedPackets& passed() const { return passed_; }
  /// As if all that was passed before had been taken, which has packets and no decoders. Sensors are recognised anew by
  /// `payload_of(route)`, for what lies beside the recording may be another by now.
  void take_up(PassedPackets passed, const std::function<std::string(const RoutePackets& route)>& payload_of);
  /// @param whole all of the recording has been seen: a sensor that has not described itself will not
  PacketIndex made(bool whole);

 private:
  bool recognise(const Datagram& datagram, RoutePackets& route);
  bool take_position(const Datagram& datagram, RoutePackets& route);
  void take_clock(const Datagram& datagram, bool follows);
  void add_packet(const Datagram& datagram, RoutePackets& route);
  void describe(const DatagramRoute& key, RoutePackets& route);

  std::filesystem::path recording_;
  std::string name_;
  SaidInRecording said_;
  PassedPackets passed_;
  std::map<std::uint32_t, std::string> last_sentences_;  ///< by the address of the sensor
};

}  // namespace remount::formats
