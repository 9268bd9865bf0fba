// Bags of packets for tests, message by message, and what is read of them.
#pragma once

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "model/formats/bags/packet_messages.h"
#include "model/formats/packets/capture_file.h"
#include "tests/model/formats/bags/bag_maker.h"

namespace remount::bags {

/// A datagram of a recording.
struct RecordedPacket {
  std::int64_t time_ns = 0;
  std::uint16_t port = 0;
  std::string payload;
};

inline std::vector<RecordedPacket> packets_of_capture(const fs::path& capture) {
  std::vector<RecordedPacket> packets;
  Progress progress;
  formats::visit_datagrams(
      formats::RandomAccessFile(capture),
      [&](const formats::Datagram& datagram) {
        packets.push_back({datagram.time_ns, datagram.route.port, std::string(datagram.payload)});
      },
      progress);
  return packets;
}

/// The port that most packets go to: that of the points.
inline std::uint16_t port_of_points(const std::vector<RecordedPacket>& packets) {
  std::map<std::uint16_t, std::size_t> counts;
  for (const RecordedPacket& packet : packets) ++counts[packet.port];
  return std::ranges::max_element(counts, {}, [](const auto& port) { return port.second; })->first;
}

/// A bag of any kind, with the definitions that messages have.
class PacketBag : public BagMaker {
 public:
  using BagMaker::BagMaker;
  /// @param in_message so many packets
  void add_packets(const std::string& topic, const std::string& type, const std::vector<RecordedPacket>& packets,
                   std::size_t in_message = 1, const std::string& frame = "lidar") {
    const PacketLayout layout = packet_layout(std::string_view(type));
    for (std::size_t from = 0; from < packets.size(); from += in_message) {
      std::vector<PacketLayout::Packet> some;
      for (std::size_t i = from; i < std::min(from + in_message, packets.size()); ++i)
        some.push_back({packets[i].time_ns, packets[i].payload});
      add(some.back().stamp_ns, topic, type, layout.write(some, frame, encoding()));
    }
  }

 private:
  MessageDefinition definition_of(const std::string& type) const override {
    return message_definition(type, encoding());
  }
};

}  // namespace remount::bags
