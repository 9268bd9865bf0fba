#include <gtest/gtest.h>

#include <cmath>

#include "algorithms/geometry/rotation.h"
#include "tests/model/formats/packets/capture_sessions.h"

namespace remount::formats {
namespace {

std::unique_ptr<PacketDecoder> decoder_of(const std::string& payload) {
  return recognised(payload, "a.pcap: 192.168.1.201:2368");
}

cloud::PointCloud decoded(const VelodynePacket& packet, const PacketSurroundings& around = {},
                          const PacketColumns& columns = {0, PacketDecoder::kAllColumns}) {
  const std::string payload = packet.bytes();
  cloud::PointCloud cloud;
  const auto decoder = decoder_of(payload);
  EXPECT_TRUE(decoder && decoder->glance(payload));
  if (decoder) decoder->decode(payload, columns, around, cloud);
  return cloud;
}

/// One return alone, of a block and a place in it.
auto only(std::size_t block, std::size_t place, std::uint16_t range = 5000) {
  return [=](std::size_t b, std::size_t p) {
    return std::pair<std::uint16_t, std::uint8_t>{b == block && p == place ? range : std::uint16_t{0}, 77};
  };
}

std::vector<std::uint16_t> even_azimuths(int first, int step) {
  std::vector<std::uint16_t> azimuths;
  for (int i = 0; i < 12; ++i) azimuths.push_back(static_cast<std::uint16_t>((first + i * step) % 36000));
  return azimuths;
}

/// Expects one point at a range, an elevation and an azimuth that is clockwise from ahead.
void expect_point(const cloud::PointCloud& cloud, double range_m, double elevation_deg, double azimuth_deg,
                  double time_us, int ring, double height_m = 0.0) {
  ASSERT_EQ(cloud.size(), 1U);
  const double up = degrees_to_radians(elevation_deg), around = degrees_to_radians(azimuth_deg);
  const Eigen::Vector3d expected(range_m * std::cos(up) * std::cos(around), -range_m * std::cos(up) * std::sin(around),
                                 range_m * std::sin(up) + height_m);
  EXPECT_LT((cloud.points[0].cast<double>() - expected).norm(), 1e-4) << cloud.points[0].transpose();
  EXPECT_NEAR(cloud.time_from_stamp_s[0], 1e-6 * time_us, 2e-9);
  EXPECT_EQ(cloud.ring[0], ring);
  EXPECT_EQ(cloud.intensity[0], 77.0f);
}

// 10 turns a second are 0.398 degrees from block to block, a block of a VLP-16 takes 110.592 us.
TEST(velodyne_packets, points_of_a_vlp16_as_its_manual_computes_them) {
  VelodynePacket packet;
  packet.azimuths = even_azimuths(9000, 40);
  packet.returns = only(0, 0);
  expect_point(decoded(packet), 10.0, -15.0, 90.0, 0.0, 0, 0.0112);
  packet.returns = only(0, 15);
  expect_point(decoded(packet), 10.0, 15.0, 90.0 + 0.4 * 15 * 2.304 / 110.592, 15 * 2.304, 15, -0.0112);
  packet.returns = only(0, 16 + 3);  // the second firing of the block
  expect_point(decoded(packet), 10.0, 3.0, 90.0 + 0.4 * (55.296 + 3 * 2.304) / 110.592, 55.296 + 3 * 2.304, 9, -0.0022);
  packet.returns = only(11, 31, 65535);
  expect_point(decoded(packet), 131.07, 15.0, 90.0 + 0.4 * 11 + 0.4 * (55.296 + 15 * 2.304) / 110.592,
               11 * 110.592 + 55.296 + 15 * 2.304, 15, -0.0112);
  expect_point(decoded(packet, {.time_from_stamp_s = 0.05}), 131.07, 15.0,
               90.0 + 0.4 * 11 + 0.4 * (55.296 + 15 * 2.304) / 110.592, 50'000 + 11 * 110.592 + 55.296 + 15 * 2.304, 15,
               -0.0112);
}

TEST(velodyne_packets, azimuths_go_over_the_full_turn) {
  VelodynePacket packet;
  packet.azimuths = even_azimuths(35790, 40);  // the sixth block begins at 35990
  packet.returns = only(5, 16);
  expect_point(decoded(packet), 10.0, -15.0, 359.9 + 0.2, 5 * 110.592 + 55.296, 0, 0.0112);
  const auto glance = decoder_of(packet.bytes())->glance(packet.bytes());
  EXPECT_EQ(glance->first_place, 35790U);
  EXPECT_EQ(glance->cut_column, 11U) << "the second firing of the sixth block is the first behind ahead";
  EXPECT_EQ(glance->cut_after_ns, 608'256U);
  EXPECT_EQ(glance->last_place, 250U);
  packet.returns = nullptr;
  EXPECT_EQ(decoded(packet, {}, {0, 11}).size() + decoded(packet, {}, {11, PacketDecoder::kAllColumns}).size(),
            12U * 32U);
  packet.azimuths = even_azimuths(9000, 40);
  EXPECT_EQ(decoder_of(packet.bytes())->glance(packet.bytes())->cut_column, 0U);
}

TEST(velodyne_packets, two_returns_are_one_where_they_are_the_same) {
  VelodynePacket packet;
  packet.mode = 0x39;
  for (int i = 0; i < 12; ++i) packet.azimuths.push_back(static_cast<std::uint16_t>(1000 + i / 2 * 40));
  packet.returns = [](std::size_t block, std::size_t place) {
    const std::uint16_t range = place == 0                     ? 5000
                                : place == 1                   ? (block % 2 == 0 ? 6000 : 5000)
                                : place == 2 && block % 2 == 1 ? 4000
                                                               : 0;
    return std::pair<std::uint16_t, std::uint8_t>{range, block % 2 == 0 ? 10 : 20};
  };
  const cloud::PointCloud cloud = decoded(packet);
  ASSERT_EQ(cloud.size(), 6U * (1 + 2 + 1));
  EXPECT_NEAR(cloud.points[0].norm(), 10.0, 0.02);
  EXPECT_NEAR(cloud.points[1].norm(), 12.0, 0.02) << "the last";
  EXPECT_NEAR(cloud.points[2].norm(), 10.0, 0.02) << "the strongest";
  EXPECT_NEAR(cloud.points[3].norm(), 8.0, 0.02);
  EXPECT_EQ(cloud.intensity[3], 20.0f);
  EXPECT_NEAR(cloud.time_from_stamp_s[4], 110.592e-6, 1e-9) << "the second pair of blocks is one block later";
  EXPECT_NEAR(cloud.time_from_stamp_s.back(), 1e-6 * (5 * 110.592 + 2 * 2.304), 1e-9);
}

TEST(velodyne_packets, other_models_have_their_own_lasers_and_times) {
  VelodynePacket packet;
  packet.azimuths = even_azimuths(9000, 20);
  packet.product = 0x24;  // Puck Hi-Res
  packet.returns = only(0, 14);
  expect_point(decoded(packet), 10.0, -0.667, 90.0 + 0.2 * 14 * 2.304 / 110.592, 14 * 2.304, 7, 0.0009);
  packet.product = 0x21;  // HDL-32E
  packet.returns = only(2, 31);
  expect_point(decoded(packet), 10.0, 10.67, 90.4 + 0.2 * 31 * 1.152 / 46.08, 2 * 46.08 + 31 * 1.152, 31);
  packet.product = 0x28;  // VLP-32C: two lasers at once, offsets in azimuth, 4 mm
  packet.returns = only(3, 1);
  expect_point(decoded(packet), 20.0, -1.0, 90.6 - 4.2, 3 * 55.296, 17);
  packet.returns = only(3, 6);
  expect_point(decoded(packet), 20.0, -0.667, 90.6 + 4.2 + 0.2 * 3 * 2.304 / 55.296, 3 * 55.296 + 3 * 2.304, 18);
}

TEST(velodyne_packets, a_vls128_has_four_blocks_a_column_and_its_stamp_at_the_fourth_group) {
  VelodynePacket packet;
  packet.product = 0xa1;
  for (std::size_t b = 0; b < 12; ++b) {
    packet.flags[b] = static_cast<std::uint16_t>(0xeeff - 0x1100 * (b % 4));
    packet.azimuths.push_back(static_cast<std::uint16_t>(9000 + b / 4 * 20));
  }
  packet.returns = only(4 + 2, 1);  // laser 65: the ninth group, behind the pause
  packet.stamp_us = 1000;
  expect_point(decoded(packet), 20.0, -0.23, 90.2 + 4.548 + 0.2 * 9 * 2.665 / 53.3, 53.3 + 9 * 2.665, 69);
  EXPECT_EQ(decoder_of(packet.bytes())->glance(packet.bytes())->sensor_time_ns, 1'000'000 - 8'700);
  // Two returns: one column, whose turn is known from the packets around.
  packet.mode = 0x39;
  for (std::size_t b = 0; b < 12; ++b)
    packet.flags[b] = static_cast<std::uint16_t>(0xeeff - 0x1100 * (b / 2 % 4)), packet.azimuths[b] = 9000;
  packet.returns = only(5, 1);
  expect_point(decoded(packet, {.places_per_s = 360'000}), 20.0, -0.23, 90.0 + 4.548 + 3600e-6 * 9 * 2.665, 9 * 2.665,
               69);
}

TEST(velodyne_packets, what_is_not_decoded_is_named) {
  VelodynePacket packet;
  packet.azimuths = even_azimuths(0, 40);
  packet.product = 0x23;
  EXPECT_ERROR(decoder_of(packet.bytes()), "product number 35");
  for (std::size_t b = 1; b < 12; b += 2) packet.flags[b] = 0xddff;
  EXPECT_EQ(decoder_of(packet.bytes())->model(), "HDL-64E") << "whatever its status says";
  EXPECT_EQ(decoder_of(std::string(1206, '\0')), nullptr);
  EXPECT_EQ(decoder_of("short"), nullptr);

  packet = VelodynePacket();
  packet.azimuths = even_azimuths(0, 40);
  const auto decoder = decoder_of(packet.bytes());
  ASSERT_TRUE(decoder);
  expect_passed_over(*decoder, packet, "azimuth", [](auto& broken) { broken.azimuths[7] = 36000; });
  expect_passed_over(*decoder, packet, "flag", [](auto& broken) { broken.flags[3] = 0; });
  expect_passed_over(*decoder, packet, "mode", [](auto& broken) { broken.mode = 0; });
  expect_passed_over(*decoder, packet, "another sensor's", [](auto& broken) { broken.product = 0x28; });
}

TEST(velodyne_packets, position_packets_hold_a_sentence_and_the_state_of_the_clock) {
  const auto position = packet_formats().front().position;
  const std::string sentence = "$GPRMC,221320,A,4846.8,N,00910.8,E,0,0,141123,,,A*5C\r\n";
  ASSERT_TRUE(position(position_packet(sentence, 2)));
  EXPECT_TRUE(position(position_packet(sentence, 2))->clock_locked);
  EXPECT_EQ(position(position_packet(sentence, 2))->sentences, sentence);
  EXPECT_FALSE(position(position_packet("", 1))->clock_locked);
  EXPECT_EQ(position(position_packet("", 0))->sentences, "");
  std::string of_hdl32 = position_packet(sentence, 2);
  of_hdl32.replace(14, 24, std::string(24, '\x21'));
  ASSERT_TRUE(position(of_hdl32)) << "its gyros stand between";
  EXPECT_TRUE(position(of_hdl32)->clock_locked);
  of_hdl32[38] = 'x';
  EXPECT_FALSE(position(of_hdl32));
  EXPECT_FALSE(position(std::string(512, 'x')));
  EXPECT_FALSE(position(std::string(100, '\0')));
}

}  // namespace
}  // namespace remount::formats
