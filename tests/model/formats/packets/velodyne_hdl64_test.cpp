#include <gtest/gtest.h>

#include <cmath>
#include <iostream>

#include "algorithms/geometry/rotation.h"
#include "tests/model/formats/packets/capture_sessions.h"
#include "tests/model/formats/packets/hdl64_calibration.h"

namespace remount::formats {
namespace {

constexpr std::int64_t kHdl64Hour_ns = 1'699'999'200'000'000'000;  // 2023-11-14, 22:00 UTC

/// Blocks of the upper lasers and the lower in turn, with a status in place of the mode.
VelodynePacket hdl64_packet(int first_azimuth = 9000, int step = 17, bool twice = false) {
  VelodynePacket packet;
  packet.mode = 'G', packet.product = 'A';
  packet.stamp_us = 800'000'288;
  for (int block = 0; block < 12; ++block) {
    packet.flags[static_cast<std::size_t>(block)] = block % 2 == 0 ? 0xeeff : 0xddff;
    packet.azimuths.push_back(
        static_cast<std::uint16_t>((first_azimuth + block / (twice ? 4 : 2) * step + 36000) % 36000));
  }
  return packet;
}

Hdl64Laser plain_laser(int laser) { return {.vert_deg = 2.0 - 0.4 * laser}; }

/// A decoder that found these files beside.
std::unique_ptr<PacketDecoder> hdl64_with(const std::vector<std::pair<std::string, std::string>>& files) {
  const TemporaryFolder folder;
  for (const auto& [name, bytes] : files) folder.write(name, bytes);
  const std::string payload = hdl64_packet().bytes();
  auto decoder = recognised(payload, "a.pcap");
  decoder->look_beside({folder.path() / "a.pcap", {0xc0a801c9, 2368}}, payload, "a.pcap");
  return decoder;
}

cloud::PointCloud hdl64_points(const PacketDecoder& decoder, const VelodynePacket& packet) {
  const std::string payload = packet.bytes();
  EXPECT_TRUE(decoder.glance(payload));
  cloud::PointCloud cloud;
  decoder.decode(payload, {0, PacketDecoder::kAllColumns}, {}, cloud);
  return cloud;
}

/// One return alone.
auto hdl64_only(std::size_t block, std::size_t place, std::uint16_t range) {
  return [=](std::size_t b, std::size_t p) {
    return std::pair<std::uint16_t, std::uint8_t>{b == block && p == place ? range : std::uint16_t{0}, 77};
  };
}

TEST(velodyne_hdl64, points_of_a_plain_calibration_have_the_manuals_times_and_rings) {
  const auto decoder = hdl64_with({{"a.xml", hdl64_xml(plain_laser)}});
  EXPECT_EQ(decoder->model(), "HDL-64E");
  EXPECT_EQ(decoder->sources_beside().size(), 1U);
  struct Expected {
    std::size_t block, place;
    double up_deg, after_us;
    int ring;
  };
  for (const Expected& e : {Expected{0, 0, 2.0, 0.0, 63},
                            {1, 0, -10.8, 0.0, 31},
                            {0, 5, 0.0, 6.0 + 1.26, 58},
                            {11, 31, -23.2, 5 * 48.0 + 42.0 + 3.66, 0}}) {
    VelodynePacket packet = hdl64_packet();
    packet.returns = hdl64_only(e.block, e.place, 5000);
    const cloud::PointCloud cloud = hdl64_points(*decoder, packet);
    ASSERT_EQ(cloud.size(), 1U);
    const double up = degrees_to_radians(e.up_deg), az = degrees_to_radians(90.0 + 0.17 * e.after_us / 48.0);
    const Eigen::Vector3d expected(10.0 * std::cos(up) * std::cos(az), -10.0 * std::cos(up) * std::sin(az),
                                   10.0 * std::sin(up));
    EXPECT_LT((cloud.points[0].cast<double>() - expected).norm(), 1e-4)
        << e.block << ": " << cloud.points[0].transpose();
    EXPECT_NEAR(cloud.time_from_stamp_s[0], 1e-6 * e.after_us, 2e-9);
    EXPECT_EQ(cloud.ring[0], e.ring);
    EXPECT_EQ(cloud.intensity[0], 77.0f);
  }
}

// Laser 0 looks 9 degrees down, begins 0.2 m above and 0.025 m left of the axis; raw range 8.8 m, 1.2 m too short far
// away, 1.3 m along x and 1.25 m along y. Computed by hand as the manual does, with a head at 30 degrees.
TEST(velodyne_hdl64, all_corrections_are_the_manuals_from_either_file) {
  const Hdl64Lasers lasers = [](int laser) {
    return laser == 0 ? Hdl64Laser{-3.0, -9.0, 120.0, 130.0, 125.0, 20.0, 2.5} : plain_laser(laser);
  };
  const double up = degrees_to_radians(-9.0), az = degrees_to_radians(33.0), d = 8.8 + 1.2;
  const double flat = d * std::cos(up) - 0.2 * std::sin(up);
  const double right = flat * std::sin(az) - 0.025 * std::cos(az), ahead = flat * std::cos(az) + 0.025 * std::sin(az);
  const double dx = d + (1.2 - 1.3) * (right - 2.4) / (25.04 - 2.4) + 1.3 - 1.2;
  const double dy = d + (1.2 - 1.25) * (ahead - 1.93) / (25.04 - 1.93) + 1.25 - 1.2;
  const Eigen::Vector3d expected((dy * std::cos(up) - 0.2 * std::sin(up)) * std::cos(az) + 0.025 * std::sin(az),
                                 -((dx * std::cos(up) - 0.2 * std::sin(up)) * std::sin(az) - 0.025 * std::cos(az)),
                                 dy * std::sin(up) + 0.2 * std::cos(up));
  for (const auto& [name, text] : {std::pair{"a.xml", hdl64_xml(lasers)}, std::pair{"a.yaml", hdl64_yaml(lasers)}}) {
    VelodynePacket packet = hdl64_packet(3000);
    packet.returns = hdl64_only(0, 0, 4400);
    const cloud::PointCloud cloud = hdl64_points(*hdl64_with({{name, text}}), packet);
    ASSERT_EQ(cloud.size(), 1U) << name;
    const double off_m = (cloud.points[0].cast<double>() - expected).norm();
    std::cout << name << ": " << 1e3 * off_m << " mm off\n";
    EXPECT_LT(off_m, 1e-5) << name;
  }
}

TEST(velodyne_hdl64, two_returns_are_told_by_azimuths_that_come_twice) {
  const auto decoder = hdl64_with({{"a.xml", hdl64_xml(plain_laser)}});
  VelodynePacket packet = hdl64_packet(9000, 20, true);
  const auto glance = decoder->glance(packet.bytes());
  ASSERT_TRUE(glance);
  EXPECT_EQ(glance->sensor_time_ns, 800'000'288'000 - 172'800);
  // The last and the strongest of laser 33 in the second column; those of the first column are the same.
  packet.returns = [](std::size_t block, std::size_t place) {
    const std::uint16_t range = place != 1                 ? 0
                                : block == 5               ? 6000
                                : block == 7               ? 5000
                                : block == 1 || block == 3 ? 4000
                                                           : 0;
    return std::pair<std::uint16_t, std::uint8_t>{range, 9};
  };
  const cloud::PointCloud cloud = hdl64_points(*decoder, packet);
  ASSERT_EQ(cloud.size(), 3U);
  EXPECT_NEAR(cloud.points[0].norm(), 8.0, 1e-5);
  EXPECT_NEAR(cloud.points[1].norm(), 12.0, 1e-5);
  EXPECT_NEAR(cloud.points[2].norm(), 10.0, 1e-5);
  EXPECT_NEAR(cloud.time_from_stamp_s[1], 1e-6 * (57.6 + 1.3), 2e-9);
}

TEST(velodyne_hdl64, turns_are_cut_within_a_packet_and_the_stamp_is_of_its_end) {
  const auto decoder = hdl64_with({{"a.xml", hdl64_xml(plain_laser)}});
  const auto glance = decoder->glance(hdl64_packet(35'960, 17).bytes());
  ASSERT_TRUE(glance);
  EXPECT_EQ(glance->sensor_time_ns, 800'000'000'000);
  EXPECT_EQ(glance->first_place, 35'960U);
  EXPECT_EQ(glance->last_place, 45U);
  EXPECT_EQ(glance->cut_column, 3U);
  EXPECT_EQ(glance->cut_after_ns, 144'000U);
  VelodynePacket broken = hdl64_packet();
  broken.azimuths[7] = 36'000;
  EXPECT_FALSE(decoder->glance(broken.bytes()));
  broken = hdl64_packet();
  broken.flags[6] = 0xddff;
  EXPECT_FALSE(decoder->glance(broken.bytes()));
  EXPECT_FALSE(decoder->glance(hdl64_packet().bytes() + "x"));
}

TEST(velodyne_hdl64, needs_a_calibration_of_its_own) {
  EXPECT_ERROR(hdl64_with({}), "Put its file beside the recording as a.xml");
  EXPECT_ERROR(hdl64_with({{"session.yaml", "ins: x.csv\n"}, {"other.xml", "<kml></kml>"}}), "as a.xml");
  EXPECT_ERROR(hdl64_with({{"32db.xml", hdl64_xml(plain_laser, 32)}}), "as a.xml");
  EXPECT_ERROR(hdl64_with({{"192.168.1.77.xml", hdl64_xml(plain_laser)}}), "as a.xml");
  const std::string one = hdl64_xml(plain_laser), other = hdl64_xml([](int) { return Hdl64Laser{.vert_deg = 1.0}; });
  EXPECT_ERROR(hdl64_with({{"db.xml", one}, {"old.xml", other}}), "db.xml and old.xml");
  EXPECT_EQ(hdl64_with({{"db.xml", one}, {"copy.xml", one}})->sources_beside().size(), 1U);
  const auto chosen = hdl64_with({{"a.xml", one}, {"192.168.1.201.xml", other}, {"db.yaml", hdl64_yaml(plain_laser)}});
  EXPECT_EQ(chosen->sources_beside().at(0).name.filename(), "192.168.1.201.xml");
  EXPECT_ERROR(hdl64_with({{"a.xml", one.substr(0, 2000)}}), "a.xml");
}

TEST(velodyne_hdl64, numbers_out_of_range_are_refused_with_the_place) {
  const auto with = [](Hdl64Laser laser) { return hdl64_xml([=](int) { return laser; }); };
  EXPECT_ERROR(hdl64_with({{"a.xml", with({.rot_deg = 361.0})}}),
               "a.xml:3: rotCorrection_ is 361, expected -360 to 360");
  EXPECT_ERROR(hdl64_with({{"a.xml", with({.up_cm = 2000.0})}}),
               "vertOffsetCorrection_ is 2000, expected -1000 to 1000");
  EXPECT_ERROR(hdl64_with({{"a.xml", with({.near_x_cm = 2000.0})}}), "expected at most 10 m");
  std::string unit = hdl64_xml(plain_laser);
  unit.replace(unit.find("0.2<"), 3, "200");
  EXPECT_ERROR(hdl64_with({{"a.xml", unit}}), "would count 2 m");
}

TEST(velodyne_hdl64, a_capture_is_turns) {
  std::vector<TimedFrame> frames;
  for (int i = 0; i < 800; ++i) {  // ten turns a second
    VelodynePacket packet = hdl64_packet();
    const double at_us = 288.0 * i;
    for (std::size_t block = 0; block < 12; ++block)
      packet.azimuths[block] =
          static_cast<std::uint16_t>(std::lround(0.36 * (at_us + 48.0 * static_cast<double>(block / 2))) % 36000);
    packet.stamp_us = static_cast<std::uint32_t>(800e6 + at_us + 288.0);
    frames.push_back(
        {kHdl64Hour_ns + 800'000'000'000 + std::llround(1e3 * (at_us + 400.0)), ethernet_udp(packet.bytes())});
  }
  const TemporaryFolder folder;
  folder.write("a.xml", hdl64_xml(plain_laser));
  const auto file = folder.write("a.pcap", pcap(frames));
  Progress progress;
  PacketIndex index = index_capture(file, progress);
  drive::Session session;
  take_scans(index, choose_sensor(index, "", "a.pcap"), session);
  ASSERT_EQ(session.scans->size(), 2U);
  EXPECT_TRUE(session.findings.empty()) << english(session.findings.front().explanation);
  for (std::size_t scan = 0; scan < 2; ++scan) {
    EXPECT_NEAR(static_cast<double>(session.scans->stamp_ns(scan) - kHdl64Hour_ns - 800'000'000'000),
                1e8 * static_cast<double>(scan), 60e3);
    EXPECT_NEAR(static_cast<double>(session.scans->load(scan).size()), 64.0 * 0.1 / 48e-6, 200.0);
  }
}

}  // namespace
}  // namespace remount::formats
