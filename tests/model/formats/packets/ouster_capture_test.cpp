// Sessions of captures of an Ouster: frames, clocks, metadata beside them.
#include <gtest/gtest.h>

#include <algorithm>

#include "tests/model/formats/packets/ouster_bytes.h"
#include "tests/model/formats/reader_fixtures.h"
#include "tests/model/formats/temporary_folder.h"
#include "tests/support/findings.h"

namespace remount::formats {
namespace {

using testing::finding_of;
using testing::has_code;
using testing::said_of;

constexpr std::int64_t kOusterBegins_ns = 1'700'000'000'000'000'000;

drive::Session ouster_session(const std::vector<TimedFrame>& frames, const OusterDescription& description = {}) {
  const TemporaryFolder folder;
  folder.write("drive.json", description.json());
  return open(folder.write("drive.pcap", pcap(frames)));
}

TEST(ouster_capture, scans_are_frames) {
  OusterPacket packet;
  packet.frame = 65'530;
  const drive::Session session =
      ouster_session(ouster_drive(660, kOusterBegins_ns, static_cast<std::uint64_t>(kOusterBegins_ns), packet));
  ASSERT_EQ(session.scans->size(), 10U) << "the eleventh is hardly begun";
  EXPECT_FALSE(has_code(session.findings, "capture-clock")) << said_of(session.findings, "capture-clock");
  EXPECT_FALSE(has_code(session.findings, "capture-missing"));
  EXPECT_EQ(session.files.size(), 2U) << "the metadata are of the session";
  for (std::size_t scan = 0; scan < 10; ++scan) {
    EXPECT_EQ(session.scans->stamp_ns(scan), kOusterBegins_ns + static_cast<std::int64_t>(scan) * 100'000'000);
    const cloud::PointCloud cloud = session.scans->load(scan);
    EXPECT_EQ(cloud.size(), 1024U * 16U);
    EXPECT_NEAR(cloud.time_from_stamp_s.back(), 0.1 - 97'656e-9, 1e-5);
  }
}

TEST(ouster_capture, a_frame_ends_where_its_number_does) {
  std::vector<TimedFrame> frames = ouster_drive(640, kOusterBegins_ns, static_cast<std::uint64_t>(kOusterBegins_ns));
  // Lost nearly a full turn: places go on as if nothing were missing. What is left of the other frame is no scan.
  frames.erase(frames.begin() + 2 * 64 + 40, frames.begin() + 2 * 64 + 40 + 63);
  const drive::Session session = ouster_session(frames);
  ASSERT_EQ(session.scans->size(), 9U);
  EXPECT_EQ(session.scans->load(2).size(), 40U * 16U * 16U);
  EXPECT_EQ(said_of(session.findings, "capture-missing"), "63 of 640 packets are missing.");
}

TEST(ouster_capture, a_field_of_view_begins_where_it_is_set_to) {
  std::vector<TimedFrame> seen;
  const std::vector<TimedFrame> frames =
      ouster_drive(640, kOusterBegins_ns, static_cast<std::uint64_t>(kOusterBegins_ns));
  for (std::size_t i = 0; i < frames.size(); ++i)
    if (i % 64 >= 20 && i % 64 < 40) seen.push_back(frames[i]);
  const drive::Session session = ouster_session(seen);
  EXPECT_EQ(session.scans->size(), 10U);
  EXPECT_FALSE(has_code(session.findings, "capture-missing"));
  EXPECT_EQ(session.scans->stamp_ns(3), kOusterBegins_ns + 300'000'000 + 20 * 1'562'500);
}

TEST(ouster_capture, a_clock_from_power_on_gives_way_to_the_hosts) {
  const drive::Session session = ouster_session(ouster_drive(640, kOusterBegins_ns, 77'000'000'000));
  EXPECT_NEAR(static_cast<double>(session.scans->stamp_ns(0) - kOusterBegins_ns), 0.0, 10e3);
  EXPECT_EQ(finding_of(session.findings, "capture-clock")->severity, drive::Severity::Warning);
}

TEST(ouster_capture, leap_seconds_of_ptp_are_taken_off) {
  constexpr std::int64_t kTai_ns = 37'000'000'000;
  OusterDescription ptp;
  ptp.mode = "TIME_FROM_PTP_1588";
  const drive::Session session =
      ouster_session(ouster_drive(640, kOusterBegins_ns, static_cast<std::uint64_t>(kOusterBegins_ns + kTai_ns)), ptp);
  EXPECT_EQ(session.scans->stamp_ns(0), kOusterBegins_ns);
  EXPECT_EQ(said_of(session.findings, "capture-tai"),
            "The LiDAR's clock counts as PTP does, without leap seconds (TAI). They are taken off the times of 640 of "
            "640 packets.");
}

TEST(ouster_capture, a_clock_that_is_set_to_follow_another_is_believed_once_it_has_a_date) {
  OusterDescription ptp;
  ptp.mode = "TIME_FROM_PTP_1588";
  const std::int64_t host_ns = kOusterBegins_ns - 400'000'000'000;  // the computer's clock is wrong
  const drive::Session dated =
      ouster_session(ouster_drive(640, host_ns, static_cast<std::uint64_t>(kOusterBegins_ns)), ptp);
  EXPECT_EQ(dated.scans->stamp_ns(0), kOusterBegins_ns);
  EXPECT_EQ(finding_of(dated.findings, "capture-clock")->severity, drive::Severity::Note);
  const drive::Session undated = ouster_session(ouster_drive(640, host_ns, 5'000'000'000), ptp);
  EXPECT_NEAR(static_cast<double>(undated.scans->stamp_ns(0) - host_ns), 0.0, 10e3) << "it follows nothing yet";
  const drive::Session free = ouster_session(ouster_drive(640, host_ns, static_cast<std::uint64_t>(kOusterBegins_ns)));
  EXPECT_NEAR(static_cast<double>(free.scans->stamp_ns(0) - host_ns), 0.0, 10e3);
}

TEST(ouster_capture, without_metadata_the_session_says_so) {
  const TemporaryFolder folder;
  const auto file = folder.write(
      "drive.pcap", pcap(ouster_drive(64, kOusterBegins_ns, static_cast<std::uint64_t>(kOusterBegins_ns))));
  EXPECT_ERROR(open(file), "beside the recording as drive.json");
}

TEST(ouster_capture, a_manifest_names_the_capture_with_its_metadata) {
  const TemporaryFolder folder;
  folder.write("raw/drive.pcap",
               pcap(ouster_drive(640, kOusterBegins_ns, static_cast<std::uint64_t>(kOusterBegins_ns))));
  folder.write("raw/drive.json", OusterDescription().json());
  folder.write("ins.txt", "1700000000 0 0 0 0 0 0 1\n1700000001 1 0 0 0 0 0 1\n");
  folder.write("session.yaml",
               "format: remount-session/1\nname: a\nins_poses: {file: ins.txt, format: tum}\n"
               "scans: {capture: raw/drive.pcap}\n");
  const drive::Session session = open(folder.path());
  EXPECT_EQ(session.format, "native");
  EXPECT_EQ(session.scans->size(), 10U);
  EXPECT_TRUE(std::ranges::any_of(session.files, [](const auto& file) { return file.filename() == "drive.json"; }));
}

TEST(ouster_capture, two_sensors_of_one_capture_have_metadata_each) {
  OusterPacket left, right;
  right.serial = 122'000'000'001, right.pixels = 32;
  std::vector<TimedFrame> frames =
      ouster_drive(640, kOusterBegins_ns, static_cast<std::uint64_t>(kOusterBegins_ns), left);
  for (TimedFrame& frame : ouster_drive(640, kOusterBegins_ns, static_cast<std::uint64_t>(kOusterBegins_ns), right,
                                        {.address = 0x0a000001, .port = 7502}))
    frames.push_back(std::move(frame));
  OusterDescription of_right;
  of_right.serial = "122000000001", of_right.pixels = 32, of_right.product = "OS-0-32";
  const TemporaryFolder folder;
  folder.write("left.json", OusterDescription().json());
  folder.write("right.json", of_right.flat());
  const auto file = folder.write("drive.pcap", pcap(frames));
  EXPECT_ERROR(open(file), "10.0.0.1:7502 (Ouster OS-0-32), 192.168.1.201:7502 (Ouster OS-1-16)");
  Progress progress;
  EXPECT_EQ(open_session(file, {{"lidar", "10.0.0.1:7502"}}, progress).scans->load(0).size(), 1024U * 32U);
}

TEST(ouster_capture, a_second_lidar_that_is_not_read_is_named) {
  std::vector<TimedFrame> frames = vlp16_drive(200, kOusterBegins_ns, 0.0);
  for (TimedFrame& frame : ouster_drive(640, kOusterBegins_ns, static_cast<std::uint64_t>(kOusterBegins_ns), {},
                                        {.address = 0x0a000001, .port = 7502}))
    frames.push_back(std::move(frame));
  const TemporaryFolder folder;
  const drive::Session session = open(folder.write("drive.pcap", pcap(frames)));
  EXPECT_GT(session.scans->size(), 0U);
  const drive::Finding* refused = finding_of(session.findings, "capture-refused");
  ASSERT_NE(refused, nullptr) << "without its metadata an Ouster cannot be read";
  EXPECT_TRUE(contains(english(refused->where), "10.0.0.1:7502")) << english(refused->where);
  EXPECT_TRUE(contains(english(refused->explanation), "drive.json")) << english(refused->explanation);
}

}  // namespace
}  // namespace remount::formats
