#include <gtest/gtest.h>

#include <cmath>

#include "algorithms/geometry/rotation.h"
#include "algorithms/messages/render.h"
#include "tests/model/formats/packets/capture_sessions.h"
#include "tests/model/formats/packets/ouster_bytes.h"

namespace remount::formats {
namespace {

constexpr char kOusterRoute[] = "a.pcap: 192.168.1.201:7502";

/// The decoder of a sensor whose metadata lies beside a capture.
std::unique_ptr<PacketDecoder> ouster_decoder(const std::string& payload, const TemporaryFolder& folder) {
  auto decoder = recognised(payload, kOusterRoute);
  if (decoder) decoder->look_beside({folder.path() / "a.pcap", {0xc0a801c9, 7502}}, payload, kOusterRoute);
  return decoder;
}

std::unique_ptr<PacketDecoder> ouster_decoder(const std::string& payload, const std::string& metadata) {
  const TemporaryFolder folder;
  folder.write("a.json", metadata);
  return ouster_decoder(payload, folder);
}

cloud::PointCloud ouster_points(const OusterPacket& packet, const std::string& metadata, double time_s = 0.0) {
  const std::string payload = packet.bytes();
  cloud::PointCloud cloud;
  const auto decoder = ouster_decoder(payload, metadata);
  EXPECT_TRUE(decoder && decoder->glance(payload));
  if (decoder) decoder->decode(payload, {0, PacketDecoder::kAllColumns}, {.time_from_stamp_s = time_s}, cloud);
  return cloud;
}

/// One pixel alone.
auto only_pixel(std::size_t column, std::size_t pixel, std::uint32_t first_mm, std::uint32_t second_mm = 0) {
  return [=](std::size_t c, std::size_t p) {
    return c == column && p == pixel ? std::array{first_mm, second_mm} : std::array<std::uint32_t, 2>{0, 0};
  };
}

/// By the manual's formulas, in the frame of the housing.
Eigen::Vector3d manual_point(double range_m, int place, double elevation_deg, double azimuth_deg, double ahead_m) {
  const double encoder = 2.0 * kPi * (1.0 - place / 1024.0), azimuth = -2.0 * kPi * azimuth_deg / 360.0;
  const double up = 2.0 * kPi * elevation_deg / 360.0;
  const double x = (range_m - ahead_m) * std::cos(encoder + azimuth) * std::cos(up) + ahead_m * std::cos(encoder);
  const double y = (range_m - ahead_m) * std::sin(encoder + azimuth) * std::cos(up) + ahead_m * std::sin(encoder);
  return {-x, -y, (range_m - ahead_m) * std::sin(up) + 0.03618};
}

TEST(ouster_packets, points_as_the_manual_computes_them) {
  OusterPacket packet;
  packet.place = 256;
  for (const auto& [column, pixel] : {std::pair<std::size_t, std::size_t>{0, 0}, {3, 5}, {15, 15}}) {
    packet.ranges = only_pixel(column, pixel, 12'345);
    const cloud::PointCloud cloud = ouster_points(packet, OusterDescription().json(), 0.05);
    ASSERT_EQ(cloud.size(), 1U);
    const Eigen::Vector3d expected =
        manual_point(12.345, 256 + static_cast<int>(column), 15.0 - 2.0 * static_cast<double>(pixel),
                     pixel % 2 == 0 ? 3.0 : -3.0, 0.015806);
    EXPECT_LT((cloud.points[0].cast<double>() - expected).norm(), 1e-5) << cloud.points[0].transpose();
    EXPECT_EQ(cloud.ring[0], 15 - static_cast<int>(pixel)) << "the last is the lowest";
    EXPECT_EQ(cloud.intensity[0], 77.0f);
    EXPECT_NEAR(cloud.time_from_stamp_s[0], 0.05 + 97'656e-9 * static_cast<double>(column), 1e-8);
  }
}

TEST(ouster_packets, all_profiles_hold_the_same_ranges) {
  for (const char* profile : {"LEGACY", "RNG19_RFL8_SIG16_NIR16", "RNG19_RFL8_SIG16_NIR16_DUAL", "RNG15_RFL8_NIR8",
                              "RNG15_RFL8_NIR8_DUAL", "FUSA_RNG15_RFL8_NIR8_DUAL"})
    for (const std::size_t pixels : {std::size_t{16}, std::size_t{128}}) {
      const std::string name(profile);
      OusterPacket packet;
      packet.profile = profile, packet.pixels = pixels, packet.fusa = name.starts_with("FUSA");
      packet.ranges = only_pixel(4, 3, 8'000, 16'000);
      OusterDescription description;
      description.profile = profile, description.pixels = pixels, description.step_deg = 0.1;
      const cloud::PointCloud cloud = ouster_points(packet, description.json());
      const bool two = name.ends_with("DUAL");
      ASSERT_EQ(cloud.size(), two ? 2U : 1U) << profile;
      EXPECT_LT((cloud.points[0].cast<double>() - manual_point(8.0, 4, 14.7, -3.0, 0.015806)).norm(), 1e-5) << profile;
      EXPECT_EQ(cloud.intensity[0], 77.0f) << profile;
      if (!two) continue;
      EXPECT_LT((cloud.points[1].cast<double>() - manual_point(16.0, 4, 14.7, -3.0, 0.015806)).norm(), 1e-5) << profile;
      EXPECT_EQ(cloud.intensity[1], 33.0f) << profile;
    }
}

TEST(ouster_packets, a_second_return_that_is_the_same_is_left_out) {
  OusterPacket packet;
  packet.profile = "RNG19_RFL8_SIG16_NIR16_DUAL";
  OusterDescription description;
  description.profile = packet.profile;
  packet.ranges = only_pixel(0, 0, 5'000, 5'000);
  EXPECT_EQ(ouster_points(packet, description.json()).size(), 1U);
  packet.ranges = only_pixel(0, 0, 0, 5'000);
  EXPECT_EQ(ouster_points(packet, description.json()).size(), 1U);
}

TEST(ouster_packets, columns_beside_the_window_give_no_points) {
  OusterPacket packet;
  packet.valid = [](std::size_t column) { return column >= 6 && column < 9; };
  const cloud::PointCloud cloud = ouster_points(packet, OusterDescription().json());
  ASSERT_EQ(cloud.size(), 3U * 16U);
  EXPECT_NEAR(cloud.time_from_stamp_s.front(), 0.0, 1e-9) << "times count from the first that was measured";
  EXPECT_NEAR(cloud.time_from_stamp_s.back(), 2 * 97'656e-9, 1e-9);
  const auto decoder = ouster_decoder(packet.bytes(), OusterDescription().json());
  const PacketGlance glance = *decoder->glance(packet.bytes());
  EXPECT_EQ(glance.first_place, 6U);
  EXPECT_EQ(glance.last_place, 8U);
  EXPECT_EQ(glance.sensor_time_ns, 1'000'000'000 + 6 * 97'656);
  packet.valid = [](std::size_t) { return false; };
  EXPECT_TRUE(decoder->glance(packet.bytes())) << "one of the sensor, without points";
  packet.place = 1020;  // beyond the turn
  packet.valid = nullptr;
  cloud::PointCloud at_end;
  decoder->decode(packet.bytes(), {0, PacketDecoder::kAllColumns}, {}, at_end);
  EXPECT_EQ(at_end.size(), 4U * 16U);
}

TEST(ouster_packets, packets_may_hold_fewer_columns) {
  OusterPacket packet;
  OusterDescription description;
  packet.columns = description.columns_in_packet = 8;
  EXPECT_EQ(ouster_points(packet, description.json()).size(), 8U * 16U);
  packet.profile = description.profile = "LEGACY";
  EXPECT_EQ(ouster_points(packet, description.flat()).size(), 8U * 16U);
}

TEST(ouster_packets, metadata_of_every_schema_say_the_same) {
  const OusterPacket packet;
  const cloud::PointCloud sections = ouster_points(packet, OusterDescription().json());
  ASSERT_EQ(sections.size(), 256U);
  EXPECT_EQ(ouster_points(packet, OusterDescription().flat()).points, sections.points);
  // The transform of the beams is preferred to the number beside it, and may lift them.
  OusterDescription lifted;
  std::string json = lifted.json();
  json.insert(json.find("\"beam_altitude"), "\"beam_to_lidar_transform\": [1,0,0,3, 0,1,0,0, 0,0,1,4, 0,0,0,1], ");
  OusterPacket one;
  one.ranges = only_pixel(0, 0, 2'005);
  const cloud::PointCloud cloud = ouster_points(one, json);
  ASSERT_EQ(cloud.size(), 1U);
  const double up = degrees_to_radians(15.0), around = degrees_to_radians(-3.0);
  const Eigen::Vector3d expected(-(2.0 * std::cos(up) * std::cos(around) + 0.003),
                                 -2.0 * std::cos(up) * std::sin(around), 2.0 * std::sin(up) + 0.004 + 0.03618);
  EXPECT_LT((cloud.points[0].cast<double>() - expected).norm(), 1e-5) << cloud.points[0].transpose();
}

TEST(ouster_packets, metadata_of_first_firmware_lack_what_was_added_later) {
  OusterPacket packet;
  packet.profile = "LEGACY", packet.pixels = 64;
  packet.ranges = only_pixel(0, 0, 12'345);
  OusterDescription description;
  description.pixels = 64, description.step_deg = 0.5, description.product = "OS-1-64";
  const std::string angles = description.beams().substr(0, description.beams().find(", \"lidar_origin"));
  const std::string old = "{" + angles + ", \"lidar_mode\": \"1024x10\", \"prod_line\": \"OS-1-64\"";
  for (const char* more :
       {"}", ", \"data_format\": \"error: Command not recognized.\", \"lidar_to_sensor_transform\": []}"}) {
    const cloud::PointCloud cloud = ouster_points(packet, old + more);
    ASSERT_EQ(cloud.size(), 1U);
    EXPECT_LT((cloud.points[0].cast<double>() - manual_point(12.345, 0, 15.0, 3.0, 0.012163)).norm(), 1e-5);
  }
}

TEST(ouster_packets, without_metadata_it_is_said_what_to_put_where) {
  const TemporaryFolder folder;
  folder.write("notes.json", "{\"a\": 1}");
  folder.write("broken.json", "{\"a\": ");
  const OusterPacket packet;
  EXPECT_ERROR(ouster_decoder(packet.bytes(), folder), "Put the sensor's metadata beside the recording as a.json");
  OusterDescription other;
  other.serial = "122000000001";
  folder.write("other.json", other.json());
  EXPECT_ERROR(ouster_decoder(packet.bytes(), folder), "other.json (OS-1-16, serial number 122000000001");
  other = OusterDescription();
  other.pixels = 32;
  folder.write("other.json", other.json());
  EXPECT_ERROR(ouster_decoder(packet.bytes(), folder), "6400 bytes");
}

TEST(ouster_packets, of_several_metadata_the_one_that_fits_best_is_taken) {
  const OusterPacket packet;
  OusterDescription other;
  other.highest_deg = 10.0;
  const auto highest_of = [&](const TemporaryFolder& folder) {
    cloud::PointCloud cloud;
    ouster_decoder(packet.bytes(), folder)->decode(packet.bytes(), {0, 1}, {}, cloud);
    const Eigen::Vector3f above = cloud.points[0] - Eigen::Vector3f(0.0f, 0.0f, 0.03618f);
    return std::round(radians_to_degrees(std::asin(above.z() / above.norm())));
  };
  const TemporaryFolder folder;
  folder.write("b.json", OusterDescription().json());
  folder.write("c.json", OusterDescription().flat());
  EXPECT_EQ(highest_of(folder), 15.0) << "both say the same";
  folder.write("c.json", other.json());
  EXPECT_ERROR(ouster_decoder(packet.bytes(), folder), "b.json and c.json");
  other.initialization = 1;
  folder.write("c.json", other.json());
  EXPECT_EQ(highest_of(folder), 15.0) << "of this start of the sensor";
  other = OusterDescription();
  other.highest_deg = 10.0, other.port = 7504;
  folder.write("c.json", other.json());
  EXPECT_EQ(highest_of(folder), 15.0) << "of this port";
  other.port = 7502;
  folder.write("c.json", OusterDescription().json());
  folder.write("a.json", other.json());
  EXPECT_EQ(highest_of(folder), 10.0) << "of the capture's name";
}

TEST(ouster_packets, broken_metadata_are_named_with_their_place) {
  const OusterPacket packet;
  const auto refused = [&](const std::string& from, const std::string& to) {
    std::string json = OusterDescription().json();
    const std::size_t at = json.find(from);
    EXPECT_NE(at, std::string::npos) << from;
    json.replace(at, from.size(), to);
    return ouster_decoder(packet.bytes(), json);
  };
  EXPECT_ERROR(refused("[15.0", "[95.0"), "beam_altitude_angles");
  EXPECT_ERROR(refused("[15.000000, ", "["), "a.json");
  EXPECT_ERROR(refused("RNG19_RFL8_SIG16_NIR16", "RNG99"), "udp_profile_lidar");
  EXPECT_ERROR(refused("[-1,0,0,0", "[-2,0,0,0"), "lidar_to_sensor_transform");
  EXPECT_ERROR(refused("\"columns_per_frame\": 1024", "\"columns_per_frame\": -5"), "columns_per_frame");
  EXPECT_ERROR(refused("[15.000000,", "[[15.000000],"), "without a turning head");
  EXPECT_ERROR(refused("_origin_mm\": 15.806", "_origin_mm\": 15806.0"), "lidar_origin_to_beam_origin_mm");
}

TEST(ouster_packets, what_is_no_packet_of_points_is_none) {
  const TemporaryFolder folder;
  folder.write("a.json", OusterDescription().json());
  OusterPacket packet;
  const std::string payload = packet.bytes();
  const auto decoder = ouster_decoder(payload, folder);
  ASSERT_TRUE(decoder);
  EXPECT_EQ(decoder->model(), "Ouster OS-1-16");
  EXPECT_FALSE(decoder->glance(payload.substr(1)));
  EXPECT_FALSE(decoder->glance(std::string(48, 'x')));
  EXPECT_FALSE(decoder->glance(std::string(payload.size(), '\0')));
  std::string of_imu = payload;
  of_imu[0] = 2;
  EXPECT_FALSE(decoder->glance(of_imu));
  OusterPacket other = packet;
  other.serial = 1;
  EXPECT_FALSE(decoder->glance(other.bytes())) << "of another sensor";
  EXPECT_EQ(ouster_decoder(std::string(payload.size(), '\0'), folder), nullptr);
  EXPECT_EQ(ouster_decoder(std::string(payload.size(), '\x01'), folder), nullptr);
  packet.step_ns = 0;  // times do not rise
  EXPECT_EQ(ouster_decoder(packet.bytes(), folder), nullptr);
}

TEST(ouster_packets, metadata_of_another_start_are_told) {
  const std::string payload = OusterPacket().bytes();
  OusterDescription description;
  const auto same = ouster_decoder(payload, description.json());
  description.initialization = 1;
  const auto other = ouster_decoder(payload, description.json());
  ASSERT_TRUE(same && other);
  EXPECT_TRUE(same->remark().empty()) << english(same->remark());
  EXPECT_TRUE(contains(english(other->remark()), "another start of the sensor than a.json"))
      << english(other->remark());
}

}  // namespace
}  // namespace remount::formats
