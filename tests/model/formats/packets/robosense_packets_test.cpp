#include <gtest/gtest.h>

#include <cmath>
#include <iostream>

#include "algorithms/geometry/rotation.h"
#include "tests/model/formats/packets/capture_sessions.h"
#include "tests/model/formats/packets/robosense_bytes.h"
#include "tests/support/findings.h"

namespace remount::formats {
namespace {

using testing::finding_of;
using testing::has_code;
using testing::said_of;

constexpr std::int64_t kRobosense_ns = 1'700'000'000'000'000'000;
constexpr char kWhere[] = "a.pcap: 192.168.1.200:6699";

std::unique_ptr<PacketDecoder> robosense_decoder_of(const std::string& payload) { return recognised(payload, kWhere); }

/// @param interval_ns from packet to packet
cloud::PointCloud msop_points(const MsopPacket& packet, const std::string& description, std::int64_t interval_ns = 0) {
  const std::string payload = packet.bytes();
  cloud::PointCloud cloud;
  const auto decoder = robosense_decoder_of(payload);
  EXPECT_TRUE(decoder && decoder->glance(payload));
  if (!decoder) return cloud;
  decoder->describe(description.empty() ? std::vector<std::string>() : std::vector{description}, kWhere);
  decoder->tune({.interval_ns = interval_ns}, kWhere);
  decoder->decode(payload, {0, PacketDecoder::kAllColumns}, {}, cloud);
  return cloud;
}

/// One return alone, of a block and a place in it.
auto only_msop_return(std::size_t block, std::size_t place, std::uint16_t range = 4000) {
  return [=](std::size_t b, std::size_t p) {
    return std::pair<std::uint16_t, std::uint8_t>{b == block && p == place ? range : std::uint16_t{0}, 77};
  };
}

struct ExpectedReturn {
  double range_m, elevation_deg, azimuth_deg, head_deg;  ///< the head is where the lens is
  double time_us;
  int ring;
  double lens_x_m, lens_z_m = 0.0;
};

/// Expects one point, by the formula of the manuals: clockwise from ahead, from where the lens is.
void expect_return(const cloud::PointCloud& cloud, const ExpectedReturn& e) {
  ASSERT_EQ(cloud.size(), 1U);
  const double up = degrees_to_radians(e.elevation_deg), around = degrees_to_radians(e.azimuth_deg),
               head = degrees_to_radians(e.head_deg);
  const Eigen::Vector3d expected(e.range_m * std::cos(up) * std::cos(around) + e.lens_x_m * std::cos(head),
                                 -e.range_m * std::cos(up) * std::sin(around) - e.lens_x_m * std::sin(head),
                                 e.range_m * std::sin(up) + e.lens_z_m);
  EXPECT_LT((cloud.points[0].cast<double>() - expected).norm(), 1e-4) << cloud.points[0].transpose();
  EXPECT_NEAR(cloud.time_from_stamp_s[0], 1e-6 * e.time_us, 2e-9);
  EXPECT_EQ(cloud.ring[0], e.ring);
  EXPECT_EQ(cloud.intensity[0], 77.0f);
}

std::string described_by(int per_deg, std::size_t lasers = 32, std::uint8_t return_mode = 4) {
  DifopPacket description;
  description.angles = even_angles(per_deg, lasers);
  description.return_mode = return_mode;
  return description.bytes();
}

MsopPacket rs16(std::vector<std::uint16_t> azimuths) {
  MsopPacket packet;
  packet.former = true, packet.legacy_type = 1, packet.type = packet.variant = 0;
  packet.time = big(23, 1) + big(11, 1) + big(14, 1) + big(22, 1) + big(13, 1) + big(20, 1) + big(123, 2) + big(456, 2);
  packet.azimuths = std::move(azimuths);
  return packet;
}

TEST(robosense_packets, points_of_a_helios) {
  MsopPacket packet;
  packet.azimuths = msop_azimuths(9000, 20);
  packet.returns = only_msop_return(0, 0);
  expect_return(msop_points(packet, described_by(100)), {10.0, -8.0, 94.0, 90.0, 0.0, 0, 0.03498});
  packet.returns = only_msop_return(3, 21);
  const double head_deg = 90.6 + 0.2 * 36.33 / 55.56;
  expect_return(msop_points(packet, described_by(100)),
                {10.0, 2.5, head_deg - 3.0, head_deg, 3 * 55.56 + 36.33, 21, 0.03498});
  EXPECT_ERROR(robosense_decoder_of(packet.bytes())->describe({}, kWhere), "port 7788");
}

TEST(robosense_packets, lasers_of_one_elevation_have_rings_of_their_own) {
  MsopPacket packet;
  packet.azimuths = msop_azimuths(9000, 20);
  DifopPacket description;
  description.angles = even_angles(100);
  description.angles[5] = description.angles[4];
  for (const auto& [laser, ring] : {std::pair<std::size_t, int>{4, 4}, {5, 5}, {6, 6}}) {
    packet.returns = only_msop_return(0, laser);
    const cloud::PointCloud cloud = msop_points(packet, description.bytes());
    ASSERT_EQ(cloud.size(), 1U);
    EXPECT_EQ(cloud.ring[0], ring) << "of laser " << laser;
  }
}

TEST(robosense_packets, points_of_an_rs32_a_bpearl_and_its_fourth_version) {
  MsopPacket packet = rs16(msop_azimuths(9000, 20));
  packet.legacy_type = 2;
  packet.returns = only_msop_return(1, 16);
  double head_deg = 90.2 + 0.2 * 1.44 / 55.52;
  expect_return(msop_points(packet, described_by(1000)), {20.0, 0.0, head_deg + 4.0, head_deg, 56.96, 16, 0.03997});
  packet.legacy_type = packet.type = 3;
  packet.returns = only_msop_return(1, 8);
  head_deg = 90.2 + 0.2 * 25.68 / 55.52;
  const ExpectedReturn of_bpearl{20.0, -4.0, head_deg + 4.0, head_deg, 55.52 + 25.68, 8, 0.01473, 0.09427};
  expect_return(msop_points(packet, described_by(100)), of_bpearl);
  DifopPacket hanging;
  hanging.angles = even_angles(100);
  hanging.upside_down = true;
  const cloud::PointCloud turned = msop_points(packet, hanging.bytes());
  ASSERT_EQ(turned.size(), 1U);
  EXPECT_GT(turned.points[0].y(), 19.0f) << "its azimuths count the other way round";
  packet.variant = 4;
  packet.time = robosense_seconds(1'700'000'000'123'456);
  head_deg = 90.2 + 0.2 * 13.34 / 55.56;
  expect_return(msop_points(packet, described_by(100)),
                {10.0, -4.0, head_deg + 4.0, head_deg, 55.56 + 13.34, 8, 0.01619, 0.09571});
}

TEST(robosense_packets, a_block_of_sixteen_lasers_is_two_rounds_or_two_returns) {
  MsopPacket packet = rs16(msop_azimuths(9000, 40));
  packet.returns = only_msop_return(2, 16 + 3);
  double head_deg = 90.8 + 0.4 * (55.5 + 8.4) / 111.0;
  expect_return(msop_points(packet, "", 1'332'000), {20.0, -9.0, head_deg, head_deg, 2 * 111.0 + 63.9, 3, 0.03825});
  packet.azimuths = msop_azimuths(9000, 20);
  head_deg = 90.4 + 0.2 * 8.4 / 55.5;
  expect_return(msop_points(packet, "", 666'000), {20.0, -9.0, head_deg, head_deg, 2 * 55.5 + 8.4, 3, 0.03825});
  packet.returns = [](std::size_t block, std::size_t place) {
    const bool said = block == 0 && (place % 16 == 5 || place == 16 + 6);
    return std::pair<std::uint16_t, std::uint8_t>{said ? std::uint16_t{1000} : std::uint16_t{0}, 1};
  };
  EXPECT_EQ(msop_points(packet, "", 666'000).size(), 2U) << "the same twice is one";
  DifopPacket description;
  for (int i = 0; i < 16; ++i) description.rs16_angles.push_back(10'000 + 1'000 * i);
  packet.returns = only_msop_return(0, 9);
  packet.azimuths = msop_azimuths(9000, 40);
  head_deg = 90.0 + 0.4 * 25.2 / 111.0;
  expect_return(msop_points(packet, description.bytes(), 1'332'000), {20.0, 1.9, head_deg, head_deg, 25.2, 9, 0.03825});
}

TEST(robosense_packets, a_helios_with_sixteen_lasers_shows_in_its_description) {
  MsopPacket packet;
  packet.legacy_type = 6, packet.type = packet.variant = 0;  // as firmware of 2023 has it
  packet.azimuths = msop_azimuths(9000, 20);
  packet.returns = only_msop_return(0, 16 + 5);
  const double head_deg = 90.0 + 0.2 * 8.65 / 55.56;
  expect_return(msop_points(packet, described_by(100, 16, 0), 666'720),
                {10.0, -5.5, head_deg - 3.0, head_deg, 8.65, 5, 0.03498});
}

TEST(robosense_packets, two_returns_are_blocks_of_one_azimuth) {
  MsopPacket packet;
  packet.azimuths = msop_azimuths(9000, 20, 2);
  packet.returns = [](std::size_t block, std::size_t place) {
    const std::uint16_t range = place == 0 ? 4000 : place == 1 ? (block % 2 == 0 ? 4000 : 8000) : 0;
    return std::pair<std::uint16_t, std::uint8_t>{range, block % 2 == 0 ? 10 : 20};
  };
  const cloud::PointCloud cloud = msop_points(packet, described_by(100, 32, 0));
  ASSERT_EQ(cloud.size(), 6U * 3U);
  EXPECT_EQ(cloud.intensity[2], 20.0f);
  EXPECT_NEAR(cloud.time_from_stamp_s[3], 55.56e-6, 1e-9) << "a pair of blocks is one round";
}

TEST(robosense_packets, points_of_a_ruby_and_a_ruby_plus) {
  DifopPacket description;
  description.room = 128;
  description.angles = even_angles(100, 128);
  const auto found = [&](std::size_t lasers, std::uint8_t type, std::uint8_t variant, std::size_t blocks,
                         std::size_t laser, const std::string& model) {
    std::vector<std::uint16_t> azimuths;
    for (std::size_t b = 0; b < blocks; ++b) azimuths.push_back(static_cast<std::uint16_t>(9000 + 20 * b));
    const std::string payload = ruby_packet(
        lasers, type, variant, azimuths,
        [&](std::size_t block, std::size_t l) -> std::uint16_t { return block == 1 && l == laser ? 2000 : 0; });
    const auto decoder = robosense_decoder_of(payload);
    EXPECT_EQ(decoder->model(), model);
    EXPECT_EQ(decoder->glance(payload)->sensor_time_ns, kRobosense_ns + 123'456'000) << model;
    EXPECT_ERROR(decoder->describe({}, kWhere), "port 7788");
    decoder->describe({description.bytes()}, kWhere);
    cloud::PointCloud cloud;
    decoder->decode(payload, {0, PacketDecoder::kAllColumns}, {}, cloud);
    return cloud;
  };
  const auto expect = [](const cloud::PointCloud& cloud, std::size_t laser, double round_us, double after_us,
                         double lens_m) {
    const double head_deg = 90.2 + 0.2 * after_us / round_us;
    expect_return(cloud, {10.0, -8.0 + 0.5 * static_cast<double>(laser), head_deg + (laser % 2 == 0 ? 4.0 : -3.0),
                          head_deg, round_us + after_us, static_cast<int>(laser), lens_m});
  };
  expect(found(128, 0, 0, 3, 70, "RS-Ruby-128"), 70, 55.55, 3.236, 0.03615);
  expect(found(128, 5, 1, 3, 64, "RS-Ruby-Plus-128"), 64, 55.56, 21.14, 0.02892);
  expect(found(80, 4, 0, 4, 75, "RS-Ruby-80"), 75, 55.552, 45.304, 0.03615);
  expect(found(80, 5, 2, 4, 74, "RS-Ruby-Plus-80"), 74, 55.56, 50.603, 0.02892);
  expect(found(80, 5, 3, 4, 79, "RS-Ruby-Plus-80V"), 79, 55.56, 31.963, 0.02892);
  expect(found(48, 5, 4, 8, 47, "RS-Ruby-Plus-48"), 47, 55.56, 40.666, 0.02892);
  expect(found(48, 0, 0, 8, 4, "RS-Ruby-48"), 4, 55.552, 12.944, 0.03615);
}

TEST(robosense_packets, two_returns_of_a_ruby_go_on_in_the_next_packet) {
  const auto payload = [](std::vector<std::uint16_t> azimuths) {
    return ruby_packet(128, 5, 1, azimuths, [](std::size_t block, std::size_t) { return std::uint16_t(1000 + block); });
  };
  DifopPacket description;
  description.room = 128;
  description.angles = even_angles(100, 128);
  for (const auto& [azimuths, second_us] : {std::pair{std::vector<std::uint16_t>{9000, 9000, 9020}, 0.0},
                                            {std::vector<std::uint16_t>{9020, 9040, 9040}, 55.56}}) {
    const std::string bytes = payload(azimuths);
    const auto decoder = robosense_decoder_of(bytes);
    decoder->describe({description.bytes()}, kWhere);
    cloud::PointCloud cloud;
    decoder->decode(bytes, {0, PacketDecoder::kAllColumns}, {}, cloud);
    ASSERT_EQ(cloud.size(), 3U * 128U);
    // Of two blocks of one azimuth the returns of a laser follow each other.
    const std::size_t first_of_second_block = second_us == 0.0 ? 1 : 128;
    EXPECT_NEAR(cloud.time_from_stamp_s[first_of_second_block], 1e-6 * second_us, 1e-9);
  }
}

TEST(robosense_packets, turns_end_within_a_packet) {
  MsopPacket packet = rs16(msop_azimuths(35910, 20));
  packet.legacy_type = 2;
  const auto decoder = robosense_decoder_of(packet.bytes());
  const auto glance = decoder->glance(packet.bytes());
  EXPECT_EQ(glance->first_place, 35910U);
  EXPECT_EQ(glance->cut_column, 5U);
  EXPECT_EQ(glance->cut_after_ns, 277'600U);
  EXPECT_EQ(glance->last_place, 130U);
  EXPECT_EQ(glance->sensor_time_ns, kRobosense_ns + 123'456'000);
  // A sensor that looks at a part of the turn has nothing between two blocks: 300 degrees of a turn of a tenth of a
  // second.
  packet.azimuths = msop_azimuths(3000, 20);
  for (std::size_t b = 6; b < 12; ++b) packet.azimuths[b] = static_cast<std::uint16_t>(33'000 + 20 * (b - 6));
  packet.returns = only_msop_return(6, 0);
  decoder->describe({described_by(1000)}, kWhere);
  cloud::PointCloud cloud;
  decoder->decode(packet.bytes(), {0, PacketDecoder::kAllColumns}, {}, cloud);
  ASSERT_EQ(cloud.size(), 1U);
  EXPECT_NEAR(cloud.time_from_stamp_s[0], 1e-6 * (5 * 55.52 + 299.0 / 0.2 * 55.52), 1e-6);
}

TEST(robosense_packets, an_m1_says_the_direction_of_each_point) {
  const auto points = [](std::size_t block, std::size_t channel) {
    return block == 7 && channel == 2 ? std::array<int, 3>{2000, -1050, 4500} : std::array<int, 3>{};
  };
  const std::string payload = m1_packet(629, 2, 1'700'000'000'123'456, points);
  const auto decoder = robosense_decoder_of(payload);
  ASSERT_NE(decoder, nullptr);
  EXPECT_EQ(decoder->model(), "RS-LiDAR-M1");
  EXPECT_EQ(decoder->glance(payload)->first_place, 629U);
  EXPECT_TRUE(decoder->glance(payload)->clock_follows.value());
  cloud::PointCloud cloud;
  decoder->decode(payload, {0, PacketDecoder::kAllColumns}, {}, cloud);
  ASSERT_EQ(cloud.size(), 1U);
  const double up = degrees_to_radians(-10.5), left = degrees_to_radians(45.0);
  EXPECT_LT((cloud.points[0].cast<double>() -
             10.0 * Eigen::Vector3d(std::cos(up) * std::cos(left), std::cos(up) * std::sin(left), std::sin(up)))
                .norm(),
            1e-5);
  EXPECT_NEAR(cloud.time_from_stamp_s[0], 42e-6, 1e-10);
  EXPECT_TRUE(cloud.ring.empty());
  // Frames are of 630 packets.
  std::vector<TimedFrame> frames;
  for (std::size_t i = 0; i < 3 * 630; ++i) {
    const auto after_us = static_cast<std::int64_t>(i) * 158;
    frames.push_back(
        {kRobosense_ns + 1000 * (after_us + 158),
         ethernet_udp(m1_packet(static_cast<std::uint16_t>(1 + i % 630), 0, 1'700'000'000'000'000 + after_us, points),
                      {.port = 6699})});
  }
  const drive::Session session = scans_of(frames);
  EXPECT_FALSE(has_code(session.findings, "capture-missing"));
  ASSERT_EQ(session.scans->size(), 3U);
  EXPECT_EQ(session.scans->stamp_ns(1), kRobosense_ns + 630 * 158'000);
  EXPECT_EQ(session.scans->load(1).size(), 630U);
}

TEST(robosense_packets, what_is_not_decoded_is_named) {
  MsopPacket packet;
  packet.azimuths = msop_azimuths(0, 20);
  packet.type = 9;
  EXPECT_ERROR(robosense_decoder_of(packet.bytes()), "of type 0 9");
  EXPECT_EQ(robosense_decoder_of(std::string(1248, '\0')), nullptr);
  packet = MsopPacket();
  packet.azimuths = msop_azimuths(0, 20);
  const auto decoder = robosense_decoder_of(packet.bytes());
  ASSERT_TRUE(decoder);
  expect_passed_over(*decoder, packet, "azimuth", [](auto& broken) { broken.azimuths[7] = 36000; });
  expect_passed_over(*decoder, packet, "another sensor's", [](auto& broken) { broken.type = 3; });
  expect_passed_over(*decoder, packet, "time", [](auto& broken) { broken.time = big(0, 6) + big(1'000'000, 4); });
  EXPECT_FALSE(decoder->glance(packet.bytes().substr(1)));
}

TEST(robosense_packets, captures_with_the_sensors_description) {
  const drive::Session session = scans_of(helios_drive(800, kRobosense_ns, 1'700'000'000'000'000));
  EXPECT_TRUE(session.findings.empty());
  ASSERT_EQ(session.scans->size(), 5U) << "half a second and a bit";
  for (std::size_t scan = 0; scan < 5; ++scan) {
    EXPECT_NEAR(static_cast<double>(session.scans->stamp_ns(scan) - kRobosense_ns), 1e8 * static_cast<double>(scan),
                7e5);
    const cloud::PointCloud cloud = session.scans->load(scan);
    EXPECT_NEAR(static_cast<double>(cloud.size()), 57'600.0, 400.0);
    EXPECT_EQ(*std::max_element(cloud.ring.begin(), cloud.ring.end()), 31);
  }
  std::vector<TimedFrame> alone = helios_drive(100, kRobosense_ns, 1'700'000'000'000'000);
  alone.erase(alone.begin());
  EXPECT_ERROR(scans_of(alone), "RS-Helios, and none in which it says where its lasers look");
}

TEST(robosense_packets, a_clock_that_the_description_says_is_set_is_believed) {
  const std::int64_t host_ns = kRobosense_ns + 3'600'000'000'000;
  const drive::Session set = scans_of(helios_drive(300, host_ns, 1'700'000'000'000'000));
  EXPECT_NEAR(static_cast<double>(set.scans->stamp_ns(0) - kRobosense_ns), 0.0, 1e6);
  std::vector<TimedFrame> frames = helios_drive(300, host_ns, 77'000'000);
  DifopPacket free;
  free.sync = 0;
  free.angles = even_angles(100);
  frames[0].bytes = ethernet_udp(free.bytes(), {.port = 7788});
  const drive::Session moved = scans_of(frames);
  EXPECT_NEAR(static_cast<double>(moved.scans->stamp_ns(0) - host_ns), 0.0, 1e6);
  EXPECT_TRUE(contains(said_of(moved.findings, "capture-clock"), "follows no receiver"));
}

TEST(robosense_packets, an_rs16_without_a_description_has_the_elevations_of_its_data_sheet) {
  std::vector<TimedFrame> frames;
  for (std::size_t i = 0; i < 300; ++i) {
    MsopPacket packet = rs16(msop_azimuths(static_cast<int>(i * 480 % 36000), 40));
    const std::size_t after_us = i * 1332;
    packet.time = big(23, 1) + big(11, 1) + big(14, 1) + big(22, 1) + big(13, 1) + big(20, 1) +
                  big(after_us / 1000, 2) + big(after_us % 1000, 2);
    frames.push_back({kRobosense_ns + static_cast<std::int64_t>(after_us + 1332) * 1000,
                      ethernet_udp(packet.bytes(), {.port = 6699})});
  }
  const drive::Session session = scans_of(frames);
  EXPECT_TRUE(contains(said_of(session.findings, "capture-angles"), "elevations of the data sheet"));
  ASSERT_EQ(session.scans->size(), 4U);
  EXPECT_NEAR(static_cast<double>(session.scans->load(1).size()), 75.0 * 384.0, 400.0);
}

TEST(robosense_packets, descriptions_hold_a_sentence_and_the_state_of_the_clock) {
  const auto position_of = [](const std::string& payload) -> std::optional<PositionPacket> {
    for (const PacketFormat& format : packet_formats())
      if (format.id == "robosense") return format.position(payload);
    return std::nullopt;
  };
  DifopPacket description;
  description.sentence = "$GPRMC,221320,A,4846.8,N,00910.8,E,0,0,141123,,,A*5C\r\n";
  ASSERT_TRUE(position_of(description.bytes()));
  EXPECT_TRUE(position_of(description.bytes())->clock_locked);
  EXPECT_EQ(position_of(description.bytes())->sentences, description.sentence);
  EXPECT_EQ(position_of(description.bytes())->description, description.bytes());
  description.time = big(23, 1) + big(11, 1);  // of a former sensor
  EXPECT_FALSE(position_of(description.bytes())->clock_locked);
  description.status = 3;
  EXPECT_TRUE(position_of(description.bytes())->clock_locked);
  EXPECT_FALSE(position_of(std::string(1248, '\0')));
  EXPECT_FALSE(position_of("short"));
}

}  // namespace
}  // namespace remount::formats
