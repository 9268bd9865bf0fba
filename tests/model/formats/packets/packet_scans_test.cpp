// What the packets of a sensor tell together: their usual time, which way it turns, how many columns a turn has.
#include "model/formats/packets/packet_scans.h"

#include <gtest/gtest.h>

#include <iostream>

#include "algorithms/geometry/rotation.h"
#include "tests/model/formats/packets/hesai_bytes.h"
#include "tests/model/formats/packets/ouster_bytes.h"
#include "tests/model/formats/packets/robosense_bytes.h"
#include "tests/model/formats/reader_fixtures.h"
#include "tests/model/formats/temporary_folder.h"
#include "tests/support/findings.h"

namespace remount::formats {
namespace {

using testing::has_code;
using testing::said_of;

constexpr std::int64_t kSequenceBegins_ns = 1'700'000'000'000'000'000;

drive::Session sequence_session(const std::vector<TimedFrame>& frames, const std::string& beside = "drive.txt",
                                const std::string& text = "") {
  const TemporaryFolder folder;
  folder.write(beside, text);
  return open(folder.write("drive.pcap", pcap(frames)));
}

/// A Ruby Plus with two returns of each column: a packet has one and a half, of which the next has the other half.
std::vector<TimedFrame> ruby_of_two_returns(std::size_t packets) {
  DifopPacket description;
  description.room = 128, description.return_mode = 0;
  description.angles = even_angles(100, 128);
  std::vector<TimedFrame> frames{{kSequenceBegins_ns, ethernet_udp(description.bytes(), {.port = 7788})}};
  for (std::size_t i = 0; i < packets; ++i) {
    const std::size_t first = i / 2 * 3 + i % 2;
    std::vector<std::uint16_t> azimuths;
    for (const std::size_t column : {first, i % 2 == 0 ? first : first + 1, first + 1})
      azimuths.push_back(static_cast<std::uint16_t>(20 * column % 36'000));
    const std::int64_t after_ns = std::llround(55'560.0 * static_cast<double>(first));
    std::string payload = ruby_packet(
        128, 5, 1, azimuths, [](std::size_t block, std::size_t) { return static_cast<std::uint16_t>(2000 + block); });
    payload.replace(10, 10, robosense_seconds((kSequenceBegins_ns + after_ns) / 1000));
    frames.push_back({kSequenceBegins_ns + after_ns + 111'120, ethernet_udp(payload, {.port = 6699})});
  }
  return frames;
}

TEST(packet_scans, packets_that_hold_one_column_and_two_in_turn_miss_nothing) {
  std::vector<TimedFrame> frames = ruby_of_two_returns(4'000);
  const drive::Session whole = sequence_session(frames);
  EXPECT_FALSE(has_code(whole.findings, "capture-missing")) << said_of(whole.findings, "capture-missing");
  EXPECT_EQ(whole.scans->size(), 3U);
  frames.erase(frames.begin() + 1'501, frames.begin() + 1'511);
  EXPECT_EQ(said_of(sequence_session(frames).findings, "capture-missing"), "10 of 4000 packets are missing.");
}

TEST(packet_scans, times_that_are_decades_apart_are_compared_too) {
  std::vector<IndexedPacket> packets(4);
  packets[1].time_ns = 1'500'000'000'000'000'000, packets[2].time_ns = 1'600'000'000'000'000'000;
  packets[3].time_ns = 4'500'000'000'000'000'000;
  std::vector<drive::Finding> findings;
  const PacketSequence sequence = order_packets(packets, 36'000, "drive.lvx", findings);
  EXPECT_EQ(sequence.interval_ns, packets[1].time_ns) << "half of what two take differs by half";
  EXPECT_TRUE(findings.empty()) << "that is a pause";
}

TEST(packet_scans, many_packets_that_miss_at_random_leave_the_usual_time) {
  std::vector<IndexedPacket> packets;
  std::uint32_t random = 7;
  std::size_t left_out = 0;
  for (std::int64_t i = 0; i < 20'000; ++i) {
    random = random * 1'664'525U + 1'013'904'223U;
    IndexedPacket packet;
    packet.time_ns = i * 1'000'000;
    packet.first_place = packet.last_place = static_cast<std::uint32_t>(i * 360 % 36'000);
    if (i == 0 || i == 19'999 || (random >> 16U) % 100 >= 40)
      packets.push_back(packet);
    else
      ++left_out;
  }
  std::vector<drive::Finding> findings;
  EXPECT_EQ(order_packets(packets, 36'000, "a.pcap", findings).interval_ns, 1'000'000) << left_out << " left out";
}

TEST(packet_scans, packets_of_one_column_show_together_which_way_the_sensor_turns) {
  // A Pandar128 with two returns of each column, 1200 turns a minute counter-clockwise.
  constexpr double kStep_us = 27.778, kDegPerUs = 0.0072;
  HesaiPacket packet = HesaiPacket::pandar128();
  packet.mode = 0x39, packet.rpm = 1200;
  packet.returns = [](std::size_t block, std::size_t channel) {
    return std::pair<std::uint16_t, std::uint8_t>{channel == 0 && block == 0 ? 2500 : 0, 77};
  };
  std::vector<TimedFrame> frames;
  for (std::size_t i = 0; i < 8'100; ++i) {
    const double after_us = kStep_us * static_cast<double>(i);
    const double encoder_deg = 360.0 - std::fmod(after_us * kDegPerUs, 360.0);
    packet.azimuths.assign(2, static_cast<std::uint16_t>(std::lround(100.0 * encoder_deg) % 36'000));
    packet.stamp_us = static_cast<std::uint32_t>(std::lround(after_us));
    frames.push_back({kSequenceBegins_ns + std::llround(1e3 * after_us), ethernet_udp(packet.bytes())});
  }
  std::string table = "Channel,Elevation,Azimuth\n";
  for (int channel = 0; channel < 128; ++channel)
    table += std::to_string(channel + 1) + "," + std::to_string(14.0 - 0.25 * channel) + ",1.5\n";
  const drive::Session session = sequence_session(frames, "drive.csv", table);
  ASSERT_EQ(session.scans->size(), 4U) << "four and a half turns";
  double worst_deg = 0.0;
  for (std::size_t scan = 0; scan < 4; ++scan) {
    const cloud::PointCloud cloud = session.scans->load(scan);
    EXPECT_NEAR(static_cast<double>(cloud.size()), 1'800.0, 3.0);
    for (std::size_t i = 0; i < cloud.size(); ++i) {
      const double fired_us = 1e-3 * static_cast<double>(session.scans->stamp_ns(scan) - kSequenceBegins_ns) +
                              1e6 * static_cast<double>(cloud.time_from_stamp_s[i]);
      // The packet's time is 3.148 us behind its stamp.
      const double expected_deg = 1.5 - kDegPerUs * (fired_us - 3.148);
      const double azimuth_deg =
          radians_to_degrees(std::atan2(static_cast<double>(cloud.points[i].x()), cloud.points[i].y()));
      worst_deg = std::max(worst_deg, std::abs(std::remainder(azimuth_deg - expected_deg, 360.0)));
    }
  }
  std::cout << "counter-clockwise: at most " << worst_deg << " degrees off\n";
  EXPECT_LT(worst_deg, 0.015) << "0.064 where it turns the other way";
}

// A packet of 16 columns has more of them than a thirty-sixth of a turn of 512.
TEST(packet_scans, metadata_of_another_mode_than_the_packets_are_refused) {
  for (const std::size_t found : {512U, 1024U, 2048U}) {
    const std::vector<TimedFrame> frames =
        ouster_drive(10 * found / 16, kSequenceBegins_ns, static_cast<std::uint64_t>(kSequenceBegins_ns),
                     OusterPacket(), {.port = 7502}, found);
    for (const std::size_t said : {512U, 1024U, 2048U}) {
      OusterDescription description;
      description.columns = static_cast<decltype(description.columns)>(said);
      if (said == found) {
        EXPECT_EQ(sequence_session(frames, "drive.json", description.json()).scans->size(), 10U) << found;
        continue;
      }
      EXPECT_ERROR(sequence_session(frames, "drive.json", description.json()),
                   ("mode of drive.json, with " + std::to_string(said) + " columns in a turn: they have about " +
                    std::to_string(found))
                       .c_str());
    }
  }
}

/// The same drive of a sensor that turns the other way: azimuths are those of blocks of packets.
template <class Packet, class Take>
std::vector<TimedFrame> falling_drive(Packet packet, double packet_us, std::uint16_t port, const Take& take_time) {
  std::vector<TimedFrame> frames;
  for (std::size_t i = 0; i < 600; ++i) {
    const double at_us = packet_us * static_cast<double>(i);
    packet.azimuths.clear();
    for (std::size_t block = 0; block < 12; ++block) {
      const double turned = 0.36 * (at_us + packet_us * static_cast<double>(block) / 12.0);
      packet.azimuths.push_back(static_cast<std::uint16_t>(35'999 - std::lround(turned) % 36'000));
    }
    take_time(packet, std::llround(at_us));
    frames.push_back(
        {kSequenceBegins_ns + std::llround(1e3 * (at_us + packet_us)), ethernet_udp(packet.bytes(), {.port = port})});
  }
  return frames;
}

TEST(packet_scans, a_sensor_that_turns_the_other_way_is_refused_where_its_times_would_be_wrong) {
  DifopPacket description;
  description.angles = even_angles(100);
  std::vector<TimedFrame> helios =
      falling_drive(MsopPacket(), 12 * 55.56, 6699, [](MsopPacket& packet, std::int64_t after_us) {
        packet.time = robosense_seconds(kSequenceBegins_ns / 1000 + after_us);
      });
  helios.insert(helios.begin(), {kSequenceBegins_ns, ethernet_udp(description.bytes(), {.port = 7788})});
  EXPECT_ERROR(sequence_session(helios),
               "192.168.1.201:6699: holds packets of a RS-Helios that turns counter-clockwise");
  const std::vector<TimedFrame> puck =
      falling_drive(VelodynePacket(), 12 * 110.592, 2368, [](VelodynePacket& packet, std::int64_t after_us) {
        packet.stamp_us = static_cast<std::uint32_t>(800'000'000 + after_us);  // 22:13:20
      });
  EXPECT_ERROR(sequence_session(puck), "192.168.1.201:2368: holds packets of a VLP-16 that turns counter-clockwise");
}

}  // namespace
}  // namespace remount::formats
