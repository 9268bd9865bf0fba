// Packets in bags give the scans that the same packets give in a capture.
#include "model/formats/bags/bag_packets.h"

#include <gtest/gtest.h>

#include <iostream>

#include "algorithms/messages/render.h"
#include "model/formats/files/input_file.h"
#include "model/simulator/lidar_model.h"
#include "model/simulator/simulator.h"
#include "tests/model/formats/bags/packet_bags.h"
#include "tests/model/formats/bags/sqlite_fixture.h"
#include "tests/model/formats/packets/hesai_bytes.h"
#include "tests/model/formats/packets/robosense_bytes.h"

namespace remount::bags {
namespace {

using drive::Session;
using formats::TemporaryFolder;
using testing::has_code;
using testing::said_of;

std::unique_ptr<BagWriter> ros1_writer(const fs::path& folder) {
  return make_rosbag1_writer(folder / "drive.bag", ChunkCompression::Lz4, 200'000);
}
std::unique_ptr<BagWriter> mcap_packets_writer(const fs::path& folder) {
  return make_mcap_writer(folder / "drive.mcap", MessageEncoding::Cdr, ChunkCompression::Zstd, 200'000);
}
std::unique_ptr<BagWriter> database_writer(const fs::path& folder) { return make_sqlite_writer(folder / "drive.db3"); }

/// A simulated drive in a format of captures.
fs::path written_capture(const std::string& format, const fs::path& folder) {
  simulator::SimulationOptions options;
  options.duration_s = 0.7;
  if (format == "robosense-m1") options.lidar.model = simulator::lidar_named("m1");
  Progress progress;
  simulator::write_drive(simulator::simulate_drive(options), folder, format, 2, progress);
  return folder / "capture.pcap";
}

/// Codes and words of what is said of packets; places are other ones, and not every driver publishes position packets.
std::vector<std::string> said_of_packets(const Session& session) {
  std::vector<std::string> said;
  for (const drive::Finding& finding : session.findings)
    if (finding.code.starts_with("capture-") && finding.code != "capture-position")
      said.push_back(finding.code + ": " + english(finding.explanation));
  return said;
}

void expect_same_scans(const Session& bag, const Session& capture, const std::string& what) {
  ASSERT_TRUE(bag.scans && capture.scans) << what;
  ASSERT_EQ(bag.scans->size(), capture.scans->size()) << what;
  ASSERT_GT(bag.scans->size(), 3U) << what;
  EXPECT_EQ(bag.scan_timing, drive::ScanTiming::PerPoint);
  EXPECT_EQ(said_of_packets(bag), said_of_packets(capture)) << what;
  std::size_t points = 0, other = 0;
  for (std::size_t scan = 0; scan < bag.scans->size(); ++scan) {
    EXPECT_EQ(bag.scans->stamp_ns(scan), capture.scans->stamp_ns(scan)) << what;
    const cloud::PointCloud ours = bag.scans->load(scan), theirs = capture.scans->load(scan);
    other += ours.points != theirs.points || ours.time_from_stamp_s != theirs.time_from_stamp_s ||
             ours.ring != theirs.ring || ours.intensity != theirs.intensity;
    points += ours.size();
  }
  EXPECT_EQ(other, 0U) << what;
  EXPECT_GT(points, 10'000U) << what;
  std::cout << what << ": " << points << " points of " << bag.scans->size() << " scans are the same\n";
}

/// How a driver publishes what its sensor sends.
struct DriverOfPackets {
  const char *capture, *topic, *type;
  std::size_t in_message = 1;
  bool all_ports = false;             ///< on one topic
  const char* other_topic = nullptr;  ///< of what goes to other ports
  const char* other_type = nullptr;
  const char* description = nullptr;  ///< the topic with the file beside the capture
  const char* description_type = nullptr;
  bool stamped_packets = true;
};

constexpr DriverOfPackets kDrivers[] = {
    {"velodyne", "/velodyne_packets", "velodyne_msgs/VelodyneScan", 76},
    {"velodyne", "/packets", "velodyne_msgs/VelodynePacket"},
    {"velodyne", "/sensing/lidar/top/packets", "nebula_msgs/NebulaPackets", 50},
    {"ouster", "/ouster/lidar_packets", "ouster_ros/PacketMsg", 1, false, nullptr, nullptr, "/ouster/metadata",
     "std_msgs/String"},
    {"ouster", "/ouster/lidar_packets", "ouster_sensor_msgs/PacketMsg"},
    {"hesai", "/hesai/pandar_packets", "pandar_msgs/PandarScan", 100},
    {"hesai", "/hesai/pandar_packets", "hesai_lidar/PandarScan", 100},
    {"hesai", "/lidar_packets", "hesai_ros_driver/UdpFrame", 100, false, nullptr, nullptr, "/lidar_corrections",
     "std_msgs/UInt8MultiArray", false},
    {"robosense", "/rslidar_packets", "rslidar_msg/RslidarPacket", 1, true},
    {"robosense", "/rslidar_packets", "rslidar_msgs/rslidarScan", 84, false, "/rslidar_packets_difop",
     "rslidar_msgs/rslidarPacket"},
    {"robosense-m1", "/rslidar_packets", "rslidar_msg/RslidarPacket", 1, true},
};

fs::path packets_as_bag(const DriverOfPackets& driver, const fs::path& capture, const fs::path& folder,
                        std::unique_ptr<BagWriter> writer) {
  const std::vector<RecordedPacket> packets = packets_of_capture(capture);
  const std::uint16_t port = simulator::port_of_points(packets);
  std::vector<RecordedPacket> points, others;
  for (const RecordedPacket& packet : packets)
    (packet.port == port || driver.all_ports ? points : others).push_back(packet);
  PacketBag bag(std::move(writer));
  bag.add_lists(driver.topic, driver.type, points, {driver.in_message, "lidar", driver.stamped_packets});
  if (driver.other_topic) bag.add_packets(driver.other_topic, driver.other_type, others);
  for (const char* ending : {".json", ".csv"}) {
    const fs::path beside = fs::path(capture).replace_extension(ending);
    if (!fs::exists(beside)) continue;
    if (driver.description == nullptr) {
      fs::copy_file(beside, folder / ("drive" + std::string(ending)));
      continue;
    }
    const std::string text = formats::read_regular_file(beside);
    const bool words = std::string_view(driver.description_type) == "std_msgs/String";
    bag.add(packets.front().time_ns, driver.description, driver.description_type,
            words ? text_message(text, bag.encoding()) : bytes_message(text, bag.encoding()));
  }
  bag.finish();
  return folder;
}

TEST(bag_packets, of_every_driver_give_the_scans_of_a_capture_in_every_bag) {
  std::map<std::string, std::pair<std::shared_ptr<TemporaryFolder>, fs::path>> captures;
  for (const DriverOfPackets& driver : kDrivers) {
    auto& [kept, capture] = captures[driver.capture];
    if (!kept) {
      kept = std::make_shared<TemporaryFolder>();
      capture = written_capture(driver.capture, kept->path() / "d");
    }
    const Session captured = opened(capture);
    for (const auto make : {ros1_writer, mcap_packets_writer, database_writer}) {
      const TemporaryFolder folder;
      const Session bag = opened(packets_as_bag(driver, capture, folder.path(), make(folder.path())));
      EXPECT_EQ(bag.format, "ros-bag");
      EXPECT_EQ(bag.lidar_name, driver.topic);
      expect_same_scans(bag, captured, std::string(driver.type) + " in " + bag.files.front().filename().string());
    }
  }
}

TEST_F(packets_in_a_bag, have_the_times_of_their_messages_where_the_sensors_clock_follows_nothing) {
  // 13 minutes off, as a clock that was never set is.
  const std::vector<RecordedPacket> packets = puck_packets(400, kTenHours_ns + 800'000'000'000, 12e6);
  PacketBag made = bag();
  made.add_packets("/velodyne_packets", "velodyne_msgs/VelodyneScan", packets, 76);
  made.finish();
  const TemporaryFolder capture;
  const fs::path pcap =
      capture.write("a.pcap", formats::pcap(formats::vlp16_drive(400, kTenHours_ns + 800'000'000'000, 12e6)));
  const Session read = opened(path());
  EXPECT_TRUE(has_code(read.findings, "capture-clock")) << "the messages' times are used";
  expect_same_scans(read, opened(pcap), "on the host's clock");
}

TEST_F(packets_in_a_bag, without_stamps_have_the_recorders_times) {
  std::vector<RecordedPacket> packets = puck_packets(400, kTenHours_ns + 800'000'000'000, 12e6);
  PacketBag made = bag();
  const PacketLayout layout = packet_layout(std::string_view("velodyne_msgs/VelodynePacket"));
  for (const RecordedPacket& packet : packets)
    made.add(packet.time_ns, "/packets", "velodyne_msgs/VelodynePacket",
             layout.write({{0, packet.payload}}, "", made.encoding()));
  made.finish();
  const Session read = opened(path());
  ASSERT_GT(read.scans->size(), 3U);
  EXPECT_NEAR(static_cast<double>(read.scans->stamp_ns(0) - kTenHours_ns - 800'000'000'000), 0.0, 2e6);
}

TEST_F(packets_in_a_bag, several_lidars_are_told_apart_by_their_topics) {
  PacketBag made = bag();
  made.add_packets("/front/packets", "velodyne_msgs/VelodyneScan", puck_packets(400, kTenHours_ns, 0.0), 76, "front");
  made.add_packets("/rear/packets", "velodyne_msgs/VelodyneScan", puck_packets(800, kTenHours_ns, 0.0), 76, "rear");
  made.finish();
  Progress progress;
  const std::vector<drive::LidarOffer> offers = formats::offer_lidars(path(), progress);
  ASSERT_EQ(offers.size(), 2U);
  std::size_t scans = 0;
  for (const drive::LidarOffer& offer : offers) {
    const Session session = formats::open_session(path(), offer.choice, progress);
    EXPECT_EQ(session.lidar_name, offer.name);
    EXPECT_FALSE(offer.rare);
    EXPECT_GT(session.scans->size(), scans) << "the rear has twice as many";
    scans = session.scans->size();
  }
}

TEST_F(packets_in_a_bag, give_way_to_the_clouds_of_their_sensor_where_these_have_times) {
  for (const bool timed : {true, false}) {
    fs::remove(path());
    BagMaker made(path());
    made.add_scans("/velodyne_points", 10, 30, timed, 0, kStep_ns, 20'000'000, "velodyne");
    const PacketLayout layout = packet_layout(std::string_view("velodyne_msgs/VelodyneScan"));
    const std::vector<RecordedPacket> packets = puck_packets(600, kStart_ns, 1600e6);
    for (std::size_t from = 0; from + 50 <= packets.size(); from += 50) {
      std::vector<PacketLayout::Packet> some;
      for (std::size_t i = from; i < from + 50; ++i) some.push_back({packets[i].time_ns, packets[i].payload});
      made.add(some.back().stamp_ns, "/velodyne_packets", "velodyne_msgs/VelodyneScan",
               layout.write(some, "velodyne", kRos1));
    }
    made.add_odometry("/odom", 40);
    made.finish();
    EXPECT_EQ(opened(path()).lidar_name, timed ? "/velodyne_points" : "/velodyne_packets");
    EXPECT_EQ(opened(path(), {{"lidar", "/velodyne_packets"}}).lidar_name, "/velodyne_packets");
    Progress progress;
    const auto offer = formats::offer_topics(path(), progress);
    for (const drive::OfferedTopic& topic : offer->topics)
      if (topic.topic.name == "/velodyne_packets") {
        ASSERT_TRUE(topic.use("lidar"));
        EXPECT_EQ(english(topic.use("lidar")->why),
                  timed ? "packets of a VLP-16, of which /velodyne_points has the points with times already"
                        : "packets of a VLP-16; scans are made of them");
      }
    EXPECT_EQ(formats::offer_lidars(path(), progress).size(), timed ? 1U : 2U);
  }
}

TEST_F(packets_in_a_bag, of_an_ouster_need_metadata_and_say_where_to_put_them) {
  PacketBag made = bag();
  made.add_packets("/ouster/lidar_packets", "ouster_ros/PacketMsg", head_packets());
  made.finish();
  constexpr const char* kRemedy = "Put the sensor's metadata beside the recording as drive.json";
  const Session without = opened(path());
  EXPECT_FALSE(without.scans) << "it can be inspected all the same";
  EXPECT_TRUE(formats::contains(said_of(without.findings, "raw-packets"), kRemedy))
      << said_of(without.findings, "raw-packets");
  EXPECT_TRUE(formats::contains(error_of_opening({{"lidar", "/ouster/lidar_packets"}}), kRemedy))
      << error_of_opening({{"lidar", "/ouster/lidar_packets"}});
  folder_.write("drive.json", formats::OusterDescription().json());
  const Session session = opened(path());
  EXPECT_GT(session.scans->size(), 2U);
  EXPECT_EQ(session.files.size(), 2U) << "the metadata belong to what was read";
}

TEST_F(packets_in_a_bag, that_lack_their_file_do_not_take_the_place_of_points) {
  BagMaker made(path());
  made.add_scans("/ouster/points", 10, 30, false);
  const PacketLayout layout = packet_layout(std::string_view("ouster_ros/PacketMsg"));
  for (const RecordedPacket& packet : head_packets())
    made.add(kStart_ns + packet.time_ns - kTenHours_ns, "/ouster/lidar_packets", "ouster_ros/PacketMsg",
             layout.write({{0, packet.payload}}, "", kRos1));
  made.finish();
  EXPECT_EQ(opened(path()).lidar_name, "/ouster/points");
  folder_.write("drive.json", formats::OusterDescription().json());
  EXPECT_EQ(opened(path()).lidar_name, "/ouster/lidar_packets") << "its points have times";
}

TEST_F(packets_in_a_bag, of_two_ousters_take_each_its_own_metadata) {
  formats::OusterDescription left, right;
  left.serial = right.serial = "";
  right.highest_deg = left.highest_deg + 25.0;  // from 10 degrees on
  PacketBag made = bag();
  for (const auto& [device, description] :
       {std::pair<std::string, const formats::OusterDescription*>{"/left", &left}, {"/right", &right}}) {
    made.add_packets(device + "/lidar_packets", "ouster_ros/PacketMsg", head_packets(0));
    made.add(kTenHours_ns, device + "/metadata", "std_msgs/String", text_message(description->json(), made.encoding()));
  }
  made.finish();
  const auto lowest_m = [&](const char* topic) {
    float z_m = 1e9f;
    for (const Eigen::Vector3f& point : opened(path(), {{"lidar", topic}}).scans->load(0).points)
      z_m = std::min(z_m, point.z());
    return z_m;
  };
  const float left_m = lowest_m("/left/lidar_packets"), right_m = lowest_m("/right/lidar_packets");
  std::cout << "lowest points " << left_m << " and " << right_m << " m\n";
  EXPECT_NEAR(left_m, -8.0 * std::sin(degrees_to_radians(15.0)), 0.1);
  EXPECT_NEAR(right_m, 8.0 * std::sin(degrees_to_radians(10.0)), 0.1);
}

TEST_F(packets_in_a_bag, that_share_a_file_beside_the_bag_are_told) {
  std::string table = "Laser id,Elevation,Azimuth\n";
  for (int i = 0; i < 32; ++i) table += std::to_string(i + 1) + "," + std::to_string(15 - i) + ",0\n";
  const TemporaryFolder capture;
  const std::vector<RecordedPacket> packets =
      packets_of_capture(capture.write("a.pcap", formats::pcap(formats::hesai_drive(500, kTenHours_ns))));
  PacketBag made = bag();
  for (const char* topic : {"/left/packets", "/right/packets"})
    made.add_packets(topic, "hesai_ros_driver/UdpFrame", packets, 50);
  made.finish();
  EXPECT_TRUE(formats::contains(said_of(opened(path(), {{"lidar", "/left/packets"}}).findings, "capture-angles"),
                                "data sheet"));
  folder_.write("angles.csv", table);
  const std::string said = said_of(opened(path(), {{"lidar", "/left/packets"}}).findings, "capture-angles");
  EXPECT_TRUE(formats::contains(said, "The same angles.csv is used for /right/packets as well")) << said;
  EXPECT_TRUE(formats::contains(said, "this one's as left_packets.csv")) << said;
  fs::remove(folder_.path() / "angles.csv");
  folder_.write("left_packets.csv", table);
  folder_.write("right_packets.csv", table);
  EXPECT_FALSE(has_code(opened(path(), {{"lidar", "/left/packets"}}).findings, "capture-angles"));
}

TEST_F(packets_in_a_bag, of_a_sensor_that_is_not_read_are_named) {
  std::vector<RecordedPacket> packets = puck_packets(400, kTenHours_ns, 0.0);
  for (RecordedPacket& packet : packets)
    for (std::size_t block = 1; block < 12; block += 2) packet.payload[100 * block + 1] = '\xdd';  // of lower lasers
  PacketBag made = bag();
  made.add_packets("/velodyne_packets", "velodyne_msgs/VelodyneScan", packets, 76);
  made.finish();
  const Session session = opened(path());
  EXPECT_FALSE(session.scans);
  EXPECT_TRUE(formats::contains(said_of(session.findings, "raw-packets"), "packets of a Velodyne HDL-64E"))
      << said_of(session.findings, "raw-packets");
  const std::string asked = error_of_opening({{"lidar", "/velodyne_packets"}});
  EXPECT_TRUE(formats::contains(asked, "/velodyne_packets: holds packets of a Velodyne HDL-64E")) << asked;
}

TEST_F(packets_in_a_bag, that_are_cut_or_changed_are_left_out_and_told) {
  const std::vector<RecordedPacket> packets = puck_packets(800, kTenHours_ns, 0.0);
  const PacketLayout layout = packet_layout(std::string_view("velodyne_msgs/VelodyneScan"));
  PacketBag made = bag();
  for (std::size_t from = 0; from < packets.size(); from += 40) {
    std::vector<PacketLayout::Packet> some;
    for (std::size_t i = from; i < from + 40; ++i) some.push_back({packets[i].time_ns, packets[i].payload});
    std::string message = layout.write(some, "velodyne", made.encoding());
    if (from == 400) message.resize(message.size() / 2);
    made.add(some.back().stamp_ns, "/velodyne_packets", "velodyne_msgs/VelodyneScan", message);
  }
  made.finish();
  const Session session = opened(path());
  EXPECT_TRUE(has_code(session.findings, "bad-messages"));
  EXPECT_TRUE(has_code(session.findings, "capture-missing")) << "half of the packets of a message";
  EXPECT_GT(session.scans->size(), 7U);
  for (std::size_t scan = 0; scan < session.scans->size(); ++scan) EXPECT_GT(session.scans->load(scan).size(), 1000U);
}

TEST_F(packets_in_a_bag, are_scans_when_they_are_asked_for) {
  PacketBag made = bag();
  made.add_packets("/velodyne_packets", "velodyne_msgs/VelodyneScan", puck_packets(400, kTenHours_ns, 0.0), 76);
  made.finish();
  const Session session = opened(path());
  EXPECT_EQ(session.scans->name(1), "drive.bag: /velodyne_packets, scan 2");
  fs::resize_file(path(), 5000);
  EXPECT_ERROR(session.scans->load(2), "drive.bag");
}

}  // namespace
}  // namespace remount::bags
