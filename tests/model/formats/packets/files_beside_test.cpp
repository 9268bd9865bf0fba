// What tells the angles of one sensor is not taken for those of another without a word.
#include "model/formats/packets/files_beside.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/model/formats/packets/hesai_bytes.h"
#include "tests/model/formats/packets/ouster_bytes.h"
#include "tests/model/formats/packets/robosense_bytes.h"
#include "tests/model/formats/reader_fixtures.h"
#include "tests/model/formats/temporary_folder.h"
#include "tests/support/findings.h"

namespace remount::formats {
namespace {

using testing::finding_of;
using testing::has_code;
using testing::said_of;

constexpr std::int64_t kBesideBegins_ns = 1'700'000'000'000'000'000;
constexpr FrameOptions kLeft{.address = 0xc0a801c9}, kRight{.address = 0xc0a801ca};

drive::Session beside_session(const TemporaryFolder& folder, const std::string& lidar) {
  Progress progress;
  return open_session(folder.path() / "drive.pcap", {{"lidar", lidar}}, progress);
}

std::vector<TimedFrame> both(std::vector<TimedFrame> one, const std::vector<TimedFrame>& other) {
  one.insert(one.end(), other.begin(), other.end());
  return one;
}

std::string table_of_32(double by_deg) {
  std::string text = "Laser id,Elevation,Azimuth\n";
  for (int i = 0; i < 32; ++i) text += std::to_string(i + 1) + "," + std::to_string(15 - i + by_deg) + ",0\n";
  return text;
}

TEST(files_beside, a_name_has_a_whole_address) {
  const DatagramRoute route{0xc0a80114, 2368};  // 192.168.1.20
  for (const char* name : {"192.168.1.20.csv", "angles_192.168.1.20.csv", "192.168.1.20-front.csv"})
    EXPECT_TRUE(names_address(name, route)) << name;
  for (const char* name : {"192.168.1.201.csv", "1192.168.1.20.csv", "192.168.1.2.csv", "angles.csv"})
    EXPECT_FALSE(names_address(name, route)) << name;
}

TEST(files_beside, a_date_or_a_version_is_no_address_of_another_sensor) {
  const BesidePackets beside{"drive.pcap", {0xc0a80114, 2368}};  // 192.168.1.20
  for (const char* name : {"angles_24.11.28.10.csv", "hesai-v1.2.0.3.csv", "angles_192.168.1.20.csv", "angles.csv"})
    EXPECT_FALSE(names_other_address(name, beside)) << name;
  for (const char* name : {"192.168.1.21.csv", "10.0.0.5.csv", "angles_172.16.3.4.csv", "169.254.1.1.csv"})
    EXPECT_TRUE(names_other_address(name, beside)) << name;
  const BesidePackets elsewhere{"drive.pcap", {0x0b0c0d0e, 2368}};  // 11.12.13.14
  EXPECT_TRUE(names_other_address("11.12.13.15.csv", elsewhere)) << "a neighbour of the sensor";
}

double highest_m(const drive::Session& session) {
  double z_m = -1e9;
  for (const Eigen::Vector3f& point : session.scans->load(0).points)
    z_m = std::max(z_m, static_cast<double>(point.z()));
  return z_m;
}

/// Of the highest channel, 10 m away.
double height_m(double by_deg) { return 10.0 * std::sin((15.0 + by_deg) * 3.14159265358979 / 180.0); }

TEST(files_beside, a_table_that_serves_two_hesais_is_told_and_addresses_tell_whose_it_is) {
  const TemporaryFolder folder;
  folder.write("drive.pcap", pcap(both(hesai_drive(500, kBesideBegins_ns, {}, kLeft),
                                       hesai_drive(500, kBesideBegins_ns, {}, kRight))));
  EXPECT_TRUE(contains(said_of(beside_session(folder, "192.168.1.202").findings, "capture-angles"), "data sheet"));
  folder.write("angles.csv", table_of_32(0.5));
  for (const char* lidar : {"192.168.1.201", "192.168.1.202"}) {
    const drive::Session shared = beside_session(folder, lidar);
    ASSERT_TRUE(has_code(shared.findings, "capture-angles")) << lidar;
    EXPECT_EQ(finding_of(shared.findings, "capture-angles")->severity, drive::Severity::Warning);
    EXPECT_TRUE(contains(said_of(shared.findings, "capture-angles"), "The same angles.csv is used for 192.168.1.20"))
        << said_of(shared.findings, "capture-angles");
  }
  std::filesystem::remove(folder.path() / "angles.csv");
  folder.write("192.168.1.201.csv", table_of_32(0.5));
  folder.write("192.168.1.202.csv", table_of_32(-0.5));
  for (const auto& [lidar, by_deg] : {std::pair{"192.168.1.201", 0.5}, {"192.168.1.202", -0.5}}) {
    const drive::Session own = beside_session(folder, lidar);
    EXPECT_FALSE(has_code(own.findings, "capture-angles")) << said_of(own.findings, "capture-angles");
    EXPECT_NEAR(highest_m(own), height_m(by_deg), 1e-4) << lidar;
  }
}

TEST(files_beside, a_name_with_the_address_of_another_sensor_is_of_that_one) {
  const TemporaryFolder folder;
  folder.write("drive.pcap", pcap(hesai_drive(500, kBesideBegins_ns, {}, kLeft)));
  folder.write("192.168.1.202.csv", table_of_32(0.5));
  const drive::Session nominal = beside_session(folder, "");
  EXPECT_NEAR(highest_m(nominal), height_m(0.0), 1e-4) << "192.168.1.202.csv says " << height_m(0.5);
  EXPECT_TRUE(contains(said_of(nominal.findings, "capture-angles"), "data sheet"));
  folder.write("192.168.1.202.csv", "Laser id,Elevation,Azimuth\n1,95,0\n");
  EXPECT_NEAR(highest_m(beside_session(folder, "")), height_m(0.0), 1e-4) << "broken, but of another sensor";
  folder.write("192.168.1.202.csv", table_of_32(0.5));
  folder.write("angles.csv", table_of_32(-0.5));
  const drive::Session only = beside_session(folder, "");
  EXPECT_NEAR(highest_m(only), height_m(-0.5), 1e-4) << "the only one that can be this sensor's";
  EXPECT_FALSE(has_code(only.findings, "capture-angles")) << said_of(only.findings, "capture-angles");
}

TEST(files_beside, the_capture_may_have_an_address_in_its_name) {
  const TemporaryFolder folder;
  folder.write("of_192.168.1.10.pcap", pcap(hesai_drive(500, kBesideBegins_ns, {}, kLeft)));
  folder.write("of_192.168.1.10.csv", table_of_32(0.5));
  EXPECT_NEAR(highest_m(open(folder.path() / "of_192.168.1.10.pcap")), height_m(0.5), 1e-4);
}

TEST(files_beside, two_tables_with_the_sensors_address_must_agree) {
  const TemporaryFolder folder;
  folder.write("drive.pcap", pcap(hesai_drive(500, kBesideBegins_ns, {}, kLeft)));
  folder.write("192.168.1.201_new.csv", table_of_32(0.5));
  folder.write("192.168.1.201_old.csv", table_of_32(-0.5));
  EXPECT_ERROR(beside_session(folder, ""),
               "192.168.1.201_new.csv and 192.168.1.201_old.csv. Leave one of them, or name it "
               "192.168.1.201.csv");
  folder.write("192.168.1.201.csv", table_of_32(-0.5));
  EXPECT_NEAR(highest_m(beside_session(folder, "")), height_m(-0.5), 1e-4);
}

TEST(files_beside, an_address_does_not_tell_two_sensors_behind_it_apart) {
  const TemporaryFolder folder;
  FrameOptions other = kLeft;
  other.port = 2369;
  folder.write("drive.pcap", pcap(both(hesai_drive(500, kBesideBegins_ns, {}, kLeft),
                                       hesai_drive(500, kBesideBegins_ns, {}, other))));
  folder.write("192.168.1.201.csv", table_of_32(0.5));
  for (const auto& [lidar, its_other] : {std::pair{"2368", "2369"}, {"2369", "2368"}}) {
    const drive::Session session = beside_session(folder, lidar);
    EXPECT_TRUE(contains(said_of(session.findings, "capture-angles"),
                         std::string("The same 192.168.1.201.csv is used for 192.168.1.201:") + its_other))
        << said_of(session.findings, "capture-angles");
    EXPECT_TRUE(contains(said_of(session.findings, "capture-angles"), "an address of its own"));
  }
}

TEST(files_beside, metadata_without_serial_numbers_in_packets_serve_one_ouster) {
  OusterPacket packet;
  packet.profile = "LEGACY";
  const auto sensor_ns = static_cast<std::uint64_t>(kBesideBegins_ns);
  const auto frames = [&](std::uint32_t address) {
    return ouster_drive(200, kBesideBegins_ns, sensor_ns, packet, {.address = address, .port = 7502});
  };
  OusterDescription description;
  description.profile = "LEGACY";
  const TemporaryFolder folder;
  folder.write("drive.pcap", pcap(both(frames(kLeft.address), frames(kRight.address))));
  folder.write("drive.json", description.json());
  EXPECT_TRUE(contains(said_of(beside_session(folder, "192.168.1.202").findings, "capture-angles"),
                       "The same drive.json is used for 192.168.1.201:7502 as well"));
  description.highest_deg = 10.0;
  folder.write("192.168.1.202.json", description.json());
  const drive::Session own = beside_session(folder, "192.168.1.202");
  EXPECT_FALSE(has_code(own.findings, "capture-angles")) << said_of(own.findings, "capture-angles");
  EXPECT_FALSE(has_code(beside_session(folder, "192.168.1.201").findings, "capture-angles"));
}

TEST(files_beside, metadata_of_another_address_are_of_another_ouster) {
  OusterPacket packet;
  packet.profile = "LEGACY";
  const auto sensor_ns = static_cast<std::uint64_t>(kBesideBegins_ns);
  OusterDescription description;
  description.profile = "LEGACY";
  const FrameOptions options{.address = kLeft.address, .port = 7502};
  const TemporaryFolder folder;
  folder.write("drive.pcap", pcap(ouster_drive(200, kBesideBegins_ns, sensor_ns, packet, options)));
  folder.write("192.168.1.202.json", description.json());
  EXPECT_ERROR(beside_session(folder, ""), "the metadata beside it is of others: 192.168.1.202.json");
  // A sensor that says its serial number is the one of the metadata, whatever address it had before.
  const TemporaryFolder with_serials;
  with_serials.write("drive.pcap", pcap(ouster_drive(200, kBesideBegins_ns, sensor_ns, {}, options)));
  with_serials.write("192.168.1.202.json", OusterDescription().json());
  EXPECT_EQ(beside_session(with_serials, "").scans->size(), 3U);
}

TEST(files_beside, a_broken_file_of_this_sensor_is_not_replaced_by_another) {
  const TemporaryFolder folder;
  folder.write("drive.pcap", pcap(hesai_drive(500, kBesideBegins_ns, {}, kLeft)));
  folder.write("angles.csv", table_of_32(0.5));
  folder.write("192.168.1.201.csv", "Laser id,Elevation,Azimuth\n1,95,0\n");
  EXPECT_ERROR(beside_session(folder, ""), "192.168.1.201.csv:2: expected a number from -90 to 90");
  OusterPacket packet;
  OusterDescription description;
  packet.profile = description.profile = "LEGACY";
  const TemporaryFolder of_ouster;
  of_ouster.write("drive.pcap", pcap(ouster_drive(200, kBesideBegins_ns, static_cast<std::uint64_t>(kBesideBegins_ns),
                                                  packet, {.address = kLeft.address, .port = 7502})));
  of_ouster.write("any.json", description.json());
  EXPECT_EQ(beside_session(of_ouster, "").scans->size(), 3U);
  description.profile = "UNKNOWN";
  of_ouster.write("192.168.1.201.json", description.json());
  EXPECT_ERROR(beside_session(of_ouster, ""), "192.168.1.201.json: ");
}

TEST(files_beside, two_metadata_with_the_sensors_address_must_agree) {
  OusterPacket packet;
  packet.profile = "LEGACY";
  OusterDescription description;
  description.profile = "LEGACY";
  const TemporaryFolder folder;
  folder.write("drive.pcap", pcap(ouster_drive(200, kBesideBegins_ns, static_cast<std::uint64_t>(kBesideBegins_ns),
                                               packet, {.address = kLeft.address, .port = 7502})));
  folder.write("192.168.1.201_new.json", description.json());
  description.highest_deg = 10.0;
  folder.write("192.168.1.201_old.json", description.json());
  EXPECT_ERROR(beside_session(folder, ""),
               "192.168.1.201_new.json and 192.168.1.201_old.json. Leave one of them, or name it "
               "192.168.1.201.json");
  folder.write("192.168.1.201.json", description.json());
  EXPECT_EQ(beside_session(folder, "").files.back().filename(), "192.168.1.201.json");
}

TEST(files_beside, descriptions_of_several_robosenses_of_one_address_are_told) {
  std::vector<TimedFrame> frames = helios_drive(500, kBesideBegins_ns, kBesideBegins_ns / 1000);
  const auto add = [&](DifopPacket description, std::vector<std::pair<int, int>> angles) {
    description.angles = std::move(angles);
    frames.push_back({kBesideBegins_ns + 1'000'000, ethernet_udp(description.bytes(), {.port = 7789})});
  };
  const auto said = [&] {
    const TemporaryFolder folder;
    folder.write("drive.pcap", pcap(frames));
    return said_of(beside_session(folder, "").findings, "capture-angles");
  };
  DifopPacket later;
  later.time = robosense_seconds(1'700'000'001'000'000);
  later.return_mode = 0;
  add(later, even_angles(100));
  add(DifopPacket(), std::vector<std::pair<int, int>>(32, {0xffff, 0}));
  EXPECT_EQ(said(), "") << "another time, another mode, and one that does not know its angles yet";
  std::vector<std::pair<int, int>> others = even_angles(100);
  others[5].first += 20;
  add(DifopPacket(), others);
  EXPECT_TRUE(contains(said(), "there are several sensors behind it")) << said();
}

}  // namespace
}  // namespace remount::formats
