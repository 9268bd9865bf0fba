#include "model/formats/bags/packet_messages.h"

#include <gtest/gtest.h>

#include <chrono>
#include <iostream>

#include "tests/model/formats/bags/packet_bags.h"

namespace remount::bags {
namespace {

constexpr const char* kPacketTypes[] = {
    "velodyne_msgs/VelodyneScan", "velodyne_msgs/VelodynePacket", "ouster_ros/PacketMsg",
    "ouster_msgs/PacketMsg",      "ouster_sensor_msgs/PacketMsg", "pandar_msgs/PandarScan",
    "hesai_lidar/PandarScan",     "hesai_ros_driver/UdpFrame",    "hesai_ros_driver/UdpPacket",
    "rslidar_msgs/rslidarScan",   "rslidar_msgs/rslidarPacket",   "rslidar_msg/RslidarScan",
    "rslidar_msg/RslidarPacket",  "nebula_msgs/NebulaPackets"};

struct ReadPacket {
  std::int64_t stamp_ns = 0;
  std::string bytes, at_offset;  ///< as handed on, and as it stands in the message
};

std::vector<ReadPacket> read_all(const PacketLayout& layout, const std::string& message, MessageEncoding encoding,
                                 std::string* frame = nullptr) {
  std::vector<ReadPacket> packets;
  MessageReader reader(message, encoding, "a.bag: /packets, message 1");
  const auto take = [&](const MessagePacket& packet) {
    packets.push_back({packet.stamp_ns, std::string(packet.bytes), message.substr(packet.offset, packet.bytes.size())});
  };
  layout.read(reader, take, frame);
  return packets;
}

/// Of one length, each of its own bytes.
std::vector<PacketLayout::Packet> three_packets(std::size_t bytes) {
  std::vector<PacketLayout::Packet> packets;
  for (int i = 0; i < 3; ++i) {
    packets.push_back({kStart_ns + i * 1'000'003LL, std::string(bytes, static_cast<char>('a' + i))});
    packets.back().bytes.front() = '\xff';
  }
  return packets;
}

TEST(packet_messages, every_type_gives_its_packets_back_in_both_encodings) {
  for (const std::string type : kPacketTypes)
    for (const MessageEncoding encoding : {MessageEncoding::Ros1, MessageEncoding::Cdr}) {
      EXPECT_TRUE(holds_lidar_packets(type)) << type;
      const PacketLayout layout = packet_layout(std::string_view(type));
      const std::size_t bytes = type.starts_with("velodyne") ? 1206 : type.starts_with("rslidar") ? 1248 : 1080;
      const std::vector<PacketLayout::Packet> written = three_packets(bytes);
      std::string frame;
      const std::string message = layout.write(written, "top", encoding);
      const std::vector<ReadPacket> read = read_all(layout, message, encoding, &frame);
      const bool list = type.ends_with("Scan") || type.ends_with("Frame") || type.ends_with("Packets");
      ASSERT_EQ(read.size(), list ? 3U : 1U) << type;
      for (std::size_t i = 0; i < read.size(); ++i) {
        EXPECT_EQ(read[i].bytes, written[i].bytes) << type;
        EXPECT_EQ(read[i].at_offset, written[i].bytes) << type;
        EXPECT_EQ(read[i].stamp_ns, type.ends_with("PacketMsg") ? 0 : written[i].stamp_ns) << type;
      }
      if (list || type == "rslidar_msg/RslidarPacket") {
        EXPECT_EQ(frame, "top") << type;
      }
    }
  EXPECT_FALSE(holds_lidar_packets("sensor_msgs/PointCloud2"));
  EXPECT_FALSE(holds_lidar_packets("lslidar_msgs/LslidarPacket"));
}

TEST(packet_messages, are_laid_out_as_ros_does) {
  const std::string packet(1206, 'v');
  // seq, stamp, frame; how many; stamp and bytes of each.
  const std::string ros1 = raw<std::uint32_t>(7) + raw<std::uint32_t>(5) + raw<std::uint32_t>(6) + counted("top") +
                           raw<std::uint32_t>(2) + raw<std::uint32_t>(100) + raw<std::uint32_t>(200) + packet +
                           raw<std::uint32_t>(0) + raw<std::uint32_t>(0) + packet;
  const std::vector<ReadPacket> scan =
      read_all(packet_layout(std::string_view("velodyne_msgs/VelodyneScan")), ros1, MessageEncoding::Ros1);
  ASSERT_EQ(scan.size(), 2U);
  EXPECT_EQ(scan[0].stamp_ns, 100'000'000'200);
  EXPECT_EQ(scan[1].stamp_ns, 0) << "the stamp of the list is none of a packet";
  EXPECT_EQ(scan[1].at_offset, packet);
  // In CDR lengths stand at multiples of four; strings end with a zero.
  const std::string cdr = std::string("\0\1\0\0", 4) + raw<std::int32_t>(5) + raw<std::uint32_t>(6) +
                          counted(std::string("top\0", 4)) + std::string("\0\1", 2) + std::string(2, '\0') +
                          counted("0123456789");
  const std::vector<ReadPacket> difop =
      read_all(packet_layout(std::string_view("rslidar_msg/RslidarPacket")), cdr, MessageEncoding::Cdr);
  ASSERT_EQ(difop.size(), 1U);
  EXPECT_EQ(difop[0].bytes, "0123456789");
  EXPECT_EQ(difop[0].at_offset, "0123456789");
  EXPECT_EQ(difop[0].stamp_ns, 5'000'000'006);
}

TEST(packet_messages, the_definition_of_the_bag_goes_before_what_is_known) {
  const std::string definition =
      "# a scan\nHeader header\nuint8 KIND=3\nfloat64[3] angles\nint32 mode 5\nstring<=9[] notes\nPacket[] packets\n" +
      std::string(80, '=') +
      "\nMSG: any_msgs/Packet\nuint16 size\nuint8[8] data # the packet\ntime stamp\nPair[] pairs\n" +
      std::string(80, '=') + "\nMSG: any_msgs/Pair\nfloat32 a\nfloat32 b\n";
  const auto parsed = parse_message_layout(definition, "any_msgs/Scan");
  ASSERT_TRUE(parsed);
  const auto layout = PacketLayout::of(*parsed);
  ASSERT_TRUE(layout);
  const std::string message = raw<std::uint32_t>(0) + raw<std::uint32_t>(5) + raw<std::uint32_t>(6) + counted("f") +
                              std::string(24, '\0') + raw<std::int32_t>(5) + raw<std::uint32_t>(1) + counted("note") +
                              raw<std::uint32_t>(1) + raw<std::uint16_t>(5) + "12345678" + raw<std::uint32_t>(1) +
                              raw<std::uint32_t>(2) + raw<std::uint32_t>(1) + std::string(8, '\0');
  const std::vector<ReadPacket> read = read_all(*layout, message, MessageEncoding::Ros1);
  ASSERT_EQ(read.size(), 1U);
  EXPECT_EQ(read[0].bytes, "12345") << "as many as its size says";
  EXPECT_EQ(read[0].stamp_ns, 1'000'000'002);
}

TEST(packet_messages, a_definition_that_is_none_is_not_used) {
  const std::string deep = [] {  // each is twice the next
    std::string text = "M0 a\nM0 b\n";
    for (int i = 0; i < 14; ++i)
      text += std::string(80, '=') + "\nMSG: p/M" + std::to_string(i) + "\nM" + std::to_string(i + 1) + " a\nM" +
              std::to_string(i + 1) + " b\n";
    return text + std::string(80, '=') + "\nMSG: p/M14\nuint8[] data\n";
  }();
  const auto begin = std::chrono::steady_clock::now();
  for (const std::string& text :
       {std::string("Other[] packets\n"), std::string("uint8[ data\n"), std::string("uint8[99999999999] data\n"),
        std::string("Self self\n") + std::string(80, '=') + "\nMSG: p/Self\nSelf self\n", deep,
        std::string("Item[5] packets\n") + std::string(80, '=') + "\nMSG: p/Item\nuint8[] data\n"})
    EXPECT_FALSE(parse_message_layout(text, "p/M")) << text.substr(0, 80);
  const double took_s = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  std::cout << 1e3 * took_s << " ms for definitions without end\n";
  EXPECT_LT(took_s, 1.0);
  const auto empty = parse_message_layout("", "p/M");
  EXPECT_TRUE(!empty || !PacketLayout::of(*empty));
}

TEST(packet_messages, lists_of_nothing_end) {
  const auto parsed =
      parse_message_layout("Nothing[] all\nuint8[] data\n" + std::string(80, '=') + "\nMSG: p/Nothing\n\n", "p/M");
  ASSERT_TRUE(parsed);
  const std::string message = raw<std::uint32_t>(4) + counted("");
  EXPECT_EQ(read_all(*PacketLayout::of(*parsed), message, MessageEncoding::Ros1).size(), 1U);
}

TEST(packet_messages, one_that_is_cut_gives_the_packets_before_and_an_error) {
  for (const std::string type : kPacketTypes)
    for (const MessageEncoding encoding : {MessageEncoding::Ros1, MessageEncoding::Cdr}) {
      const PacketLayout layout = packet_layout(std::string_view(type));
      const std::string message = layout.write(three_packets(1206), "top", encoding);
      for (std::size_t bytes = 0; bytes < message.size(); bytes += bytes < 80 ? 1 : 97) {
        std::size_t packets = 0;
        const std::string said = formats::error_of([&] {
          MessageReader reader(std::string_view(message).substr(0, bytes), encoding, "a.bag: /packets, message 1");
          layout.read(reader, [&](const MessagePacket&) { ++packets; });
        });
        EXPECT_TRUE(formats::contains(said, "a.bag: /packets, message 1")) << type << " of " << bytes << ": " << said;
        EXPECT_LT(packets, 3U) << type;
      }
    }
}

}  // namespace
}  // namespace remount::bags
