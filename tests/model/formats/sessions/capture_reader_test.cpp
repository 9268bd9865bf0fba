#include "model/formats/sessions/capture_reader.h"

#include <gtest/gtest.h>

#include "model/drive/topic_offer.h"
#include "model/formats/sessions/several_sessions.h"
#include "tests/model/formats/packets/capture_bytes.h"
#include "tests/model/formats/reader_fixtures.h"
#include "tests/model/formats/temporary_folder.h"

namespace remount::formats {
namespace {

constexpr std::int64_t kDriveBegins_ns = 1'636'512'535'000'000'000;  // GPS week 2183, 269353 s
const double kPastTheHour_us = 2'935e6;

std::string capture_of(std::size_t packets, const FrameOptions& options = {}) {
  return pcap(vlp16_drive(packets, kDriveBegins_ns, kPastTheHour_us, options));
}

std::string ins_log() {
  std::string log;
  for (int i = 0; i < 120; ++i) log += inspvaxa(2183, 269352.5 + 0.02 * i, 90.0 + 0.1 * i);
  return log;
}

TEST(capture_reader, a_folder_with_a_capture_and_a_log_of_the_ins) {
  const TemporaryFolder folder;
  folder.write("drive.pcap", capture_of(400));
  folder.write("ins.log", ins_log());
  folder.write("notes.txt", "nothing\n");
  const drive::Session session = open(folder.path());
  EXPECT_EQ(session.format, "lidar-capture");
  EXPECT_EQ(session.ins.size(), 120U);
  EXPECT_EQ(session.ins_axes, drive::InsAxes::RightForwardUp);
  EXPECT_TRUE(session.ins_stamps_from_gps);
  ASSERT_TRUE(session.scans);
  EXPECT_EQ(session.scans->size(), 5U);
  EXPECT_NEAR(1e-9 * static_cast<double>(session.scans->stamp_ns(0) - kDriveBegins_ns), 0.0, 1e-4);
  EXPECT_EQ(session.files.size(), 2U);
  EXPECT_EQ(find(session, "one-stream"), nullptr);
}

TEST(capture_reader, a_capture_alone_is_half_a_session) {
  const TemporaryFolder folder;
  const drive::Session session = open(folder.write("drive.pcap", capture_of(200)));
  EXPECT_EQ(session.format, "lidar-capture");
  EXPECT_NE(find(session, "one-stream"), nullptr);
  EXPECT_EQ(session.scans->size(), 2U);
}

std::string sentence_of(const std::string& body) {
  unsigned sum = 0;
  for (const char c : body) sum ^= static_cast<unsigned char>(c);
  char end[8];
  std::snprintf(end, sizeof end, "*%02X\r\n", sum);
  return "$" + body + end;
}

TEST(capture_reader, position_packets_are_gnss_where_they_have_heights) {
  std::vector<TimedFrame> frames = vlp16_drive(400, kDriveBegins_ns, kPastTheHour_us);
  std::vector<TimedFrame> with_heights = frames;
  for (int i = 0; i < 10; ++i) {
    char time[16];
    std::snprintf(time, sizeof time, "0248%02d.00", 55 + i / 2);
    const std::string rmc =
        sentence_of(std::string("GPRMC,") + time + ",A,5106.982700,N,11402.295300,W,0.0,0.0,101121,,,A");
    const std::string gga =
        sentence_of(std::string("GPGGA,") + time + ",5106.982700,N,11402.295300,W,1,09,0.9,1063.6,M,-16.9,M,,");
    const std::int64_t time_ns = kDriveBegins_ns + std::int64_t{i} * 500'000'000;
    const FrameOptions port{.port = 8308};
    frames.push_back({time_ns, ethernet_udp(position_packet(rmc, 2), port)});
    with_heights.push_back({time_ns, ethernet_udp(position_packet(rmc, 2), port)});
    with_heights.push_back({time_ns, ethernet_udp(position_packet(gga, 2), port)});
  }
  const TemporaryFolder folder;
  const drive::Session session = open(folder.write("with.pcap", pcap(with_heights)));
  EXPECT_EQ(session.gnss.size(), 5U) << "each once";
  EXPECT_EQ(find(session, "one-stream"), nullptr);
  const drive::Session without = open(folder.write("without.pcap", pcap(frames)));
  EXPECT_TRUE(without.gnss.empty());
  ASSERT_NE(find(without, "capture-position"), nullptr);
}

TEST(capture_reader, a_manifest_names_the_capture_and_the_sensor) {
  const TemporaryFolder folder;
  std::vector<TimedFrame> frames = vlp16_drive(400, kDriveBegins_ns, kPastTheHour_us);
  const auto other = vlp16_drive(400, kDriveBegins_ns, kPastTheHour_us, {.address = 0x0a000001});
  frames.insert(frames.end(), other.begin(), other.end());
  folder.write("raw/drive.pcap", pcap(frames));
  folder.write("ins.txt", "0 0 0 0 0 0 0 1\n1 1 0 0 0 0 0 1\n");
  const std::string head = "format: remount-session/1\nname: a\nins_poses: {file: ins.txt, format: tum}\n";
  folder.write("session.yaml", head + "scans: {capture: raw/drive.pcap, sensor: 10.0.0.1}\n");
  const drive::Session session = open(folder.path());
  EXPECT_EQ(session.format, "native");
  EXPECT_EQ(session.scans->size(), 5U);
  EXPECT_TRUE(contains(session.scans->name(0), "10.0.0.1:2368"));
  folder.write("session.yaml", head + "lidars:\n  left: {scans: {capture: raw/drive.pcap, sensor: 10.0.0.1}}\n" +
                                   "  right: {scans: {capture: raw/drive.pcap, sensor: 192.168.1.201}}\n");
  Progress progress;
  const drive::Session right = open_session(folder.path(), {{"lidar", "right"}}, progress);
  EXPECT_EQ(right.lidar_name, "right");
  EXPECT_TRUE(contains(right.scans->name(0), "192.168.1.201:2368")) << right.scans->name(0);
  folder.write("session.yaml", head + "scans: {capture: raw/drive.pcap}\n");
  EXPECT_ERROR(open(folder.path()), "holds several LiDARs");
  folder.write("session.yaml", head + "scans: {capture: ins.txt}\n");
  EXPECT_ERROR(open(folder.path()), "is no capture of network packets");
  folder.write("session.yaml", head + "scans: {capture: raw/drive.pcap, type: pcd}\n");
  EXPECT_ERROR(open(folder.path()), "type");
}

TEST(capture_reader, one_of_several_sensors_is_chosen_as_topics_are) {
  std::vector<TimedFrame> frames = vlp16_drive(400, kDriveBegins_ns, kPastTheHour_us);
  const auto other = vlp16_drive(400, kDriveBegins_ns, kPastTheHour_us, {.address = 0x0a000001});
  frames.insert(frames.end(), other.begin(), other.end());
  const TemporaryFolder folder;
  const auto file = folder.write("drive.pcap", pcap(frames));
  Progress progress;
  const auto offer = offer_topics(file, progress);
  ASSERT_TRUE(offer);
  ASSERT_EQ(offer->topics.size(), 2U);
  EXPECT_TRUE(drive::is_ambiguous(offer->topics));
  EXPECT_EQ(offer->topics[0].topic.name, "10.0.0.1:2368");
  EXPECT_EQ(offer->topics[0].topic.type, "VLP-16");
  EXPECT_TRUE(contains(offer->open({{"lidar", "10.0.0.1:2368"}}, progress).scans->name(0), "10.0.0.1:2368"));
  const std::vector<drive::LidarOffer> lidars = offer_lidars(file, progress);
  ASSERT_EQ(lidars.size(), 2U);
  EXPECT_EQ(lidars[0].name, "10.0.0.1:2368");
  for (const drive::LidarOffer& lidar : lidars) {
    const drive::Session session = open_session(file, lidar.choice, progress);
    EXPECT_EQ(session.lidar_name, lidar.name);
    EXPECT_EQ(drive::choice_in_use(session.topics), lidar.choice);
  }
  EXPECT_ERROR(open(file), "holds several LiDARs");
  EXPECT_ERROR(open_session(file, {{"ins", "/imu"}}, progress), "lidar-capture");
  const auto one = folder.write("one.pcap", capture_of(200));
  EXPECT_FALSE(offer_topics(one, progress));
  ASSERT_EQ(offer_lidars(one, progress).size(), 1U);
  EXPECT_EQ(offer_lidars(one, progress)[0].name, open(one).lidar_name);
}

TEST(capture_reader, several_captures_of_a_folder_are_several_sessions) {
  const TemporaryFolder folder;
  folder.write("a.pcap", capture_of(200));
  folder.write("b.pcap", capture_of(200));
  folder.write("web.pcap", pcap({{1, ethernet_udp("hello", {.port = 53})}}));
  try {
    open(folder.path());
    FAIL() << "opened";
  } catch (const SeveralSessions& several) {
    EXPECT_EQ(several.sessions().size(), 2U);
  }
}

}  // namespace
}  // namespace remount::formats
