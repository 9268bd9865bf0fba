// Which LiDAR the packets, clouds and files of a bag are of.
#include "tests/model/formats/bags/packet_topics.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <iostream>

#include "algorithms/core/stamps.h"
#include "algorithms/geometry/rotation.h"
#include "algorithms/messages/render.h"
#include "model/formats/bags/bag_packets.h"
#include "tests/model/formats/ins/nmea_text.h"
#include "tests/model/formats/packets/hesai_bytes.h"
#include "tests/support/findings.h"

namespace remount::bags {
namespace {

using testing::has_code;
using testing::said_of;

std::vector<RecordedPacket> xt_packets(std::size_t count, std::int64_t host_ns) {
  const formats::TemporaryFolder folder;
  return packets_of_capture(folder.write("a.pcap", formats::pcap(formats::hesai_drive(count, host_ns))));
}

std::string angles_of_32() {
  std::string table = "Laser id,Elevation,Azimuth\n";
  for (int i = 0; i < 32; ++i) table += std::to_string(i + 1) + "," + std::to_string(15 - i) + ",0\n";
  return table;
}

TEST_F(packet_topics, the_frame_of_a_list_is_known_that_is_longer_than_what_is_looked_at) {
  PacketBag made = bag();
  for (const std::string side : {"front", "rear"})
    made.add_packets("/sensors/" + side + "_packets", kScanType, puck_packets(760, kTenHours_ns, 0.0), 76, side);
  add_clouds(made, "/sensors/front_points", {"front"});
  made.finish();
  EXPECT_EQ(offered(), (Names{"/sensors/front_points", "/sensors/rear_packets"}));
  const auto file = open_quietly(path());
  const PacketTopics topics = examine_packets(*file, Progress());
  for (const auto& [place, topic] : topics.found)
    EXPECT_TRUE(formats::contains(file->topics()[place].name, topic.frame) && !topic.frame.empty()) << topic.frame;
}

TEST_F(packet_topics, of_a_sensor_without_the_description_it_needs_do_not_take_the_place_of_its_cloud) {
  constexpr std::size_t kPackets = 3000;
  for (const std::size_t described : {kPackets, std::size_t{1700}}) {
    fs::remove(path());
    PacketBag made = bag();
    made.add_packets("/rslidar_packets", kRslidarType, helios_packets(kPackets, described, kTenHours_us));
    add_clouds(made, "/rslidar_points", {"rslidar", 19, 100'000'000, false});
    made.finish();
    const bool without = described == kPackets;
    EXPECT_EQ(opened(path()).lidar_name, without ? "/rslidar_points" : "/rslidar_packets");
    EXPECT_EQ(offered(), without ? Names{"/rslidar_points"} : (Names{"/rslidar_packets", "/rslidar_points"}));
  }
}

TEST_F(packet_topics, whose_packets_turn_out_not_to_be_scans_give_way_with_a_word) {
  for (const bool cloud : {true, false}) {
    fs::remove(path());
    folder_.write("drive.json", formats::OusterDescription().json());
    PacketBag made = bag();
    // 512 columns in a turn, where the metadata say 1024.
    made.add_packets("/ouster/lidar_packets", kHeadType, head_packets(formats::kOusterSerial, 512));
    if (cloud) add_clouds(made, "/ouster/points", {"os_sensor", 10, 100'000'000, false});
    made.finish();
    const drive::Session session = opened(path());
    EXPECT_EQ(session.lidar_name, cloud ? "/ouster/points" : "");
    const std::string said = said_of(session.findings, "raw-packets");
    EXPECT_TRUE(formats::contains(said, "1024 columns")) << said;
    EXPECT_EQ(std::ranges::count(session.findings, "raw-packets", &drive::Finding::code), 1);
    const std::string asked = error_of_opening({{"lidar", "/ouster/lidar_packets"}});
    EXPECT_TRUE(formats::contains(asked, "1024 columns")) << asked;
  }
}

TEST_F(packet_topics, what_one_sensor_says_is_not_taken_for_another) {
  formats::OusterDescription left;
  left.serial = "";
  PacketBag made = bag();
  for (const char* topic : {"/left/ouster/lidar_packets", "/right/ouster/lidar_packets"})
    made.add_packets(topic, kHeadType, head_packets(0));
  made.add(kTenHours_ns, "/left/ouster/metadata", "std_msgs/String", text_message(left.json(), made.encoding()));
  made.finish();
  EXPECT_EQ(offered(), Names{"/left/ouster/lidar_packets"});
  const std::string right = error_of_opening({{"lidar", "/right/ouster/lidar_packets"}});
  EXPECT_TRUE(formats::contains(right, "metadata")) << right;
}

TEST_F(packet_topics, within_others_take_what_is_said_nearest_to_them) {
  formats::OusterDescription front, rear;
  front.serial = rear.serial = "";
  rear.highest_deg = front.highest_deg + 25.0;
  PacketBag made = bag();
  for (const auto& [space, description] :
       {std::pair<std::string, const formats::OusterDescription*>{"/ouster", &front}, {"/ouster/rear", &rear}}) {
    made.add_packets(space + "/lidar_packets", kHeadType, head_packets(0));
    made.add(kTenHours_ns, space + "/metadata", "std_msgs/String", text_message(description->json(), made.encoding()));
  }
  made.finish();
  float lowest_m = 1e9f;
  for (const Eigen::Vector3f& point : opened(path(), {{"lidar", "/ouster/rear/lidar_packets"}}).scans->load(0).points)
    lowest_m = std::min(lowest_m, point.z());
  EXPECT_NEAR(lowest_m, 8.0 * std::sin(degrees_to_radians(10.0)), 0.1);
}

TEST_F(packet_topics, that_share_what_is_said_are_told_and_a_file_called_as_the_topic_goes_first) {
  PacketBag made = bag();
  for (const char* topic : {"/front_packets", "/rear_packets"})
    made.add_packets(topic, kFrameType, xt_packets(500, kTenHours_ns), 50);
  made.add(kTenHours_ns, "/lidar_corrections", "std_msgs/UInt8MultiArray",
           bytes_message(angles_of_32(), made.encoding()));
  made.finish();
  const drive::TopicChoice front{{"lidar", "/front_packets"}};
  const std::string said = said_of(opened(path(), front).findings, "capture-angles");
  EXPECT_TRUE(formats::contains(said, "The same /lidar_corrections is used for /rear_packets as well")) << said;
  EXPECT_TRUE(formats::contains(said, "this one's as front_packets.csv")) << said;
  folder_.write("front_packets.csv", angles_of_32());
  const drive::Session own = opened(path(), front);
  EXPECT_FALSE(has_code(own.findings, "capture-angles")) << said_of(own.findings, "capture-angles");
  EXPECT_EQ(own.files.size(), 2U);
}

TEST_F(packet_topics, of_lists_without_stamps_came_when_the_recorder_had_them) {
  // The sensor's clock is a hundred seconds behind; the list has the time of its first packet.
  const std::vector<RecordedPacket> packets = xt_packets(2000, formats::kHesaiDate_ns + 100'000'000'000);
  PacketBag made = bag();
  made.add_lists("/lidar_packets", kFrameType, packets, {250, "lidar", false});
  made.finish();
  const formats::TemporaryFolder capture;
  const drive::Session captured = opened(
      capture.write("a.pcap", formats::pcap(formats::hesai_drive(2000, formats::kHesaiDate_ns + 100'000'000'000))));
  const drive::Session session = opened(path());
  EXPECT_TRUE(has_code(session.findings, "capture-clock"));
  ASSERT_EQ(session.scans->size(), captured.scans->size());
  const double off_ms = 1e-6 * static_cast<double>(session.scans->stamp_ns(2) - captured.scans->stamp_ns(2));
  std::cout << "scans are " << off_ms << " ms from those of a capture\n";
  EXPECT_NEAR(off_ms, 0.0, 0.5);
}

TEST_F(packet_topics, whose_stamps_are_no_dates_have_the_recorders_times) {
  constexpr std::int64_t kNeverSet_us = 946'684'830'000'000;  // half a minute into the year 2000
  PacketBag made = bag();
  const PacketLayout layout = packet_layout(std::string_view(kRslidarType));
  std::int64_t since_us = 0;
  for (const RecordedPacket& packet : helios_packets(1500, 5, kNeverSet_us))
    made.add(packet.time_ns, "/rslidar_packets", kRslidarType,
             layout.write({{1000 * (kNeverSet_us + (since_us += 667)), packet.payload}}, "rslidar", made.encoding()));
  made.finish();
  const drive::Session session = opened(path());
  EXPECT_FALSE(has_code(session.findings, "capture-no-date")) << said_of(session.findings, "capture-no-date");
  EXPECT_TRUE(has_code(session.findings, "capture-clock"));
  EXPECT_GT(session.scans->size(), 7U) << "none is left out";
  EXPECT_NEAR(1e-9 * static_cast<double>(session.scans->stamp_ns(0) - kTenHours_ns), 0.0, 0.11);
}

TEST_F(packet_topics, of_a_recorder_without_a_date_are_said_to_be_so) {
  constexpr std::int64_t kBooted_ns = 100'000'000'000;
  PacketBag made = bag();
  const PacketLayout layout = packet_layout(std::string_view(kRslidarType));
  for (const RecordedPacket& packet : helios_packets(1000, 5, 946'684'830'000'000))
    made.add(packet.time_ns - kTenHours_ns + kBooted_ns, "/rslidar_packets", kRslidarType,
             layout.write({{0, packet.payload}}, "rslidar", made.encoding()));
  made.finish();
  const std::string said = said_of(opened(path()).findings, "capture-no-date");
  EXPECT_TRUE(formats::contains(said, "neither its clock nor that of the recorder")) << said;
  const formats::TemporaryFolder capture;
  const drive::Session captured =
      opened(capture.write("a.pcap", formats::pcap(formats::helios_drive(1000, kBooted_ns, 946'684'830'000'000))));
  const std::string host = said_of(captured.findings, "capture-no-date");
  EXPECT_TRUE(formats::contains(host, "the computer that captured them")) << host;
}

TEST_F(packet_topics, do_not_give_way_to_clouds_that_are_no_whole_record) {
  for (const auto& [clouds, whole] : {std::pair{CloudsOfDriver{"velodyne", 40}, true},
                                      {CloudsOfDriver{"velodyne", 4, 1'000'000'000}, false},
                                      {CloudsOfDriver{"velodyne", 15}, false}}) {
    fs::remove(path());
    PacketBag made = bag();
    made.add_packets("/velodyne_packets", kScanType, puck_packets(3000, kTenHours_ns, 0.0), 76, "velodyne");
    add_clouds(made, "/velodyne_points", clouds);
    made.finish();
    std::cout << clouds.count << " clouds, one in " << 1e-9 * static_cast<double>(clouds.period_ns)
              << " s, beside 4 s of packets: " << offered().size() << " LiDARs\n";
    EXPECT_EQ(offered().size(), whole ? 1U : 2U);
    EXPECT_EQ(opened(path()).lidar_name, whole ? "/velodyne_points" : "/velodyne_packets");
  }
}

TEST_F(packet_topics, and_clouds_are_of_one_sensor_only_where_their_names_say_so) {
  struct Case {
    const char *packets, *cloud;
    bool same;
  };
  for (const Case& its : {Case{"/lidar/ouster_packets", "/lidar/velodyne_points", false},
                          {"/packets", "/livox", false},
                          {"/vehicle/ouster_packets", "/vehicle/velodyne_points", false},
                          {"/ouster/lidar_packets", "/ouster/points", true},
                          {"/lidar/front_packets", "/lidar/front_points", true},
                          {"/lidar_packets", "/lidar_points", true},
                          {"/sensing/lidar/top/packets", "/sensing/lidar/top/points", true}}) {
    fs::remove(path());
    PacketBag made = bag();
    made.add_packets(its.packets, "velodyne_msgs/VelodynePacket", puck_packets(700, kTenHours_ns, 0.0));
    add_clouds(made, its.cloud, {"sensor"});
    made.finish();
    EXPECT_EQ(offered().size(), its.same ? 1U : 2U) << its.packets << " and " << its.cloud;
  }
}

TEST_F(packet_topics, of_sensors_with_the_frame_of_their_driver_are_told_apart_by_names) {
  for (const bool both : {true, false}) {
    fs::remove(path());
    PacketBag made = bag();
    for (const std::string side : {"/left", "/right"})
      if (both || side == "/right")
        made.add_packets(side + "/velodyne_packets", kScanType, puck_packets(700, kTenHours_ns, 0.0), 50, "velodyne");
    add_clouds(made, "/left/velodyne_points", {"velodyne"});
    made.finish();
    EXPECT_EQ(offered(), (Names{"/left/velodyne_points", "/right/velodyne_packets"}));
  }
}

TEST_F(packet_topics, that_wait_for_the_last_of_their_list_are_not_late) {
  BagMaker made(path());
  const PacketLayout layout = packet_layout(std::string_view(kScanType));
  // Lists of four turns, which begin somewhere in one.
  const std::vector<RecordedPacket> packets = puck_packets(6000, kStart_ns, 1600e6);
  for (std::size_t from = 40; from + 300 <= packets.size(); from += 300) {
    std::vector<PacketLayout::Packet> some;
    for (std::size_t i = from; i < from + 300; ++i) some.push_back({packets[i].time_ns, packets[i].payload});
    made.add(some.back().stamp_ns, "/velodyne_packets", kScanType, layout.write(some, "velodyne", kRos1));
  }
  made.add_odometry("/odom", 160);
  made.finish();
  const drive::Session session = opened(path());
  ASSERT_GT(session.scans->size(), 50U);
  for (const char* code : {"host-clock", "clock-moved"})
    EXPECT_FALSE(has_code(session.findings, code)) << said_of(session.findings, code);
}

TEST_F(packet_topics, a_description_is_of_the_lidar_whose_name_it_has) {
  struct Case {
    const char *without, *with, *description;
  };
  for (const Case& its : {Case{"/rslidar_packets", "/rslidar_packets2", "/rslidar_packets2_difop"},
                          {"/sensors/left_packets", "/sensors/right_packets", "/sensors/right_difop"}}) {
    fs::remove(path());
    PacketBag made = bag();
    const std::vector<RecordedPacket> packets = helios_packets(1500, 0, kTenHours_us),
                                      points(packets.begin() + 1, packets.end());
    made.add_packets(its.without, kRslidarType, points);
    made.add_packets(its.with, kRslidarType, points);
    made.add_packets(its.description, kRslidarType, {packets.front()});
    made.finish();
    EXPECT_EQ(offered(), Names{its.with});
    EXPECT_EQ(opened(path()).lidar_name, its.with);
    EXPECT_NE(error_of_opening({{"lidar", its.without}}), "") << its.without;
  }
}

/// What a sensor says of itself five times a second, with the sentences of the receiver that it hangs on.
std::vector<RecordedPacket> descriptions_with(const std::vector<std::string>& sentences, bool locked) {
  std::vector<RecordedPacket> packets;
  for (int i = 0; i < 10; ++i) {
    char time[16];
    std::snprintf(time, sizeof time, "2200%02d.00,", i / 5);
    formats::DifopPacket description;
    description.angles = formats::even_angles(100);
    description.sync = locked ? 1 : 0;
    const std::string& sentence = sentences[static_cast<std::size_t>(i) % sentences.size()];
    description.sentence = formats::nmea_line(sentence.substr(0, 6) + time + sentence.substr(6)) + "\r\n";
    packets.push_back({kTenHours_ns + i * 200'000'000 + 1, 7788, description.bytes()});
  }
  return packets;
}

TEST_F(packet_topics, what_the_receiver_says_in_descriptions_is_gnss_as_of_a_capture) {
  const std::string rmc = "GPRMC,A,4846.8,N,00910.8,E,0,0,141123,,,A",
                    gga = "GPGGA,4846.8000,N,00910.8000,E,4,12,0.6,300.0,M,48.0,M,,";
  const std::vector<RecordedPacket> points = helios_packets(3000, 3000, kTenHours_us);
  const auto session_of = [&](const std::vector<std::string>& sentences, const drive::TopicChoice& topics,
                              bool locked = true, bool other_gnss = false) {
    fs::remove(path());
    PacketBag made = bag();
    made.add_packets("/rslidar_packets", "rslidar_msgs/rslidarPacket", points);
    made.add_packets("/rslidar_packets_difop", "rslidar_msgs/rslidarPacket", descriptions_with(sentences, locked));
    if (other_gnss) made.add_ins("/ins", 20);
    made.finish();
    return opened(path(), topics);
  };
  const drive::Session session = session_of({rmc, gga}, {});
  ASSERT_EQ(session.gnss.size(), 2U) << "each once";
  EXPECT_EQ(session.gnss.front().stamp_ns, kTenHours_ns);
  EXPECT_NEAR(radians_to_degrees(session.gnss.front().latitude_rad), 48.0 + 46.8 / 60.0, 1e-12);
  EXPECT_NEAR(session.gnss.front().height_m, 348.0, 1e-9);
  EXPECT_TRUE(session_of({rmc, gga}, {{"gnss", "none"}}).gnss.empty());
  EXPECT_EQ(session_of({rmc, gga}, {}, true, true).gnss.size(), 20U) << "a receiver's own topic goes first";
  // Sensors hand on RMC alone, which has no height.
  EXPECT_TRUE(has_code(session_of({rmc}, {}).findings, "capture-position"));
  std::cout << session.gnss.size() << " fixes, the first at " << session.gnss.front().height_m << " m\n";
}

TEST_F(packet_topics, descriptions_say_whether_the_clock_follows_a_receiver) {
  const auto session_of = [&](bool locked) {
    fs::remove(path());
    PacketBag made = bag();
    // An hour from the computer's clock.
    made.add_packets("/rslidar_packets", "rslidar_msgs/rslidarPacket",
                     helios_packets(3000, 3000, kTenHours_us - 3'600'000'000));
    made.add_packets("/rslidar_packets_difop", "rslidar_msgs/rslidarPacket",
                     descriptions_with({"GPRMC,A,4846.8,N,00910.8,E,0,0,141123,,,A"}, locked));
    made.finish();
    return opened(path());
  };
  const drive::Session follows = session_of(true), free = session_of(false);
  EXPECT_NEAR(seconds(follows.scans->stamp_ns(0) - kTenHours_ns), -3600.0, 1.0);
  EXPECT_NEAR(seconds(free.scans->stamp_ns(0) - kTenHours_ns), 0.0, 1.0);
  EXPECT_TRUE(formats::contains(said_of(free.findings, "capture-clock"), "follows no receiver"));
}

}  // namespace
}  // namespace remount::bags
