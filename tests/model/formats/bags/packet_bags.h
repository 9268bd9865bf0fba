// Bags of packets for tests, message by message, and what is read of them.
#pragma once

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "model/formats/bags/packet_messages.h"
#include "model/formats/packets/capture_file.h"
#include "model/simulator/captured_datagrams.h"
#include "tests/model/formats/bags/bag_maker.h"
#include "tests/model/formats/packets/capture_bytes.h"
#include "tests/model/formats/packets/ouster_bytes.h"

namespace remount::bags {

/// A datagram of a recording.
using RecordedPacket = simulator::SentDatagram;

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

/// A bag of any kind, with the definitions that messages have.
class PacketBag : public BagMaker {
 public:
  using BagMaker::BagMaker;
  /// Lists of so many packets. Those that are not stamped have no time, and the message has that of its first.
  struct Lists {
    std::size_t in_message = 1;
    std::string frame = "lidar";
    bool stamped_packets = true;
  };
  void add_packets(const std::string& topic, const std::string& type, const std::vector<RecordedPacket>& packets,
                   std::size_t in_message = 1, const std::string& frame = "lidar") {
    add_lists(topic, type, packets, {in_message, frame, true});
  }
  void add_lists(const std::string& topic, const std::string& type, const std::vector<RecordedPacket>& packets,
                 const Lists& lists) {
    const PacketLayout layout = packet_layout(std::string_view(type));
    std::size_t end = 0;
    for (std::size_t from = 0; from < packets.size(); from = end) {
      end = std::min(from + lists.in_message, packets.size());
      std::vector<PacketLayout::Packet> some;
      for (std::size_t i = from; i < end; ++i)
        some.push_back({lists.stamped_packets ? packets[i].time_ns : 0, packets[i].payload});
      add(packets[end - 1].time_ns, topic, type, layout.write(some, lists.frame, encoding(), packets[from].time_ns));
    }
  }

 private:
  MessageDefinition definition_of(const std::string& type) const override {
    return message_definition(type, encoding());
  }
};

/// Of 2023-11-14, 22:00 UTC.
inline constexpr std::int64_t kTenHours_ns = 1'699'999'200'000'000'000;

/// Packets of a VLP-16 in the order of a recording. @param sensor_us of its clock
inline std::vector<RecordedPacket> puck_packets(std::size_t count, std::int64_t begins_ns, double sensor_us) {
  const formats::TemporaryFolder folder;
  return packets_of_capture(folder.write("a.pcap", formats::pcap(formats::vlp16_drive(count, begins_ns, sensor_us))));
}

/// Packets of an OS1 of that hour.
inline std::vector<RecordedPacket> head_packets(std::uint64_t serial = formats::kOusterSerial,
                                                std::size_t columns_in_turn = 1024) {
  formats::OusterPacket packet;
  packet.serial = serial;
  packet.ranges = [](std::size_t, std::size_t) { return std::array<std::uint32_t, 2>{8000, 0}; };
  const formats::TemporaryFolder folder;
  return packets_of_capture(folder.write(
      "a.pcap", formats::pcap(formats::ouster_drive(260, kTenHours_ns, static_cast<std::uint64_t>(kTenHours_ns), packet,
                                                    {.port = 7502}, columns_in_turn))));
}

inline drive::Session opened(const fs::path& path, const drive::TopicChoice& topics = {}) {
  Progress progress;
  return formats::open_session(path, topics, progress);
}

class packets_in_a_bag : public ::testing::Test {
 protected:
  fs::path path() const { return folder_.path() / "drive.bag"; }
  PacketBag bag() const { return PacketBag(make_rosbag1_writer(path(), ChunkCompression::None, 100'000)); }
  std::string error_of_opening(const drive::TopicChoice& topics = {}) const {
    return formats::error_of([&] { opened(path(), topics); });
  }
  formats::TemporaryFolder folder_;
};

}  // namespace remount::bags
