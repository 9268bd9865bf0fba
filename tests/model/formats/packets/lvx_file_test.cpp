#include "model/formats/packets/lvx_file.h"

#include <gtest/gtest.h>

#include "model/formats/packets/capture_records.h"
#include "model/formats/session_readers.h"
#include "tests/model/formats/packets/livox_bytes.h"
#include "tests/model/formats/temporary_folder.h"
#include "tests/support/findings.h"

namespace remount::formats {
namespace {

using testing::has_code;
using testing::said_of;

constexpr std::int64_t kLvxBegins_ns = 1'700'000'000'000'000'000;
const std::vector<LvxDevice> kTwoDevices{{"47MDL1B0010008", 3, 9}, {"0TFDG3U99102431", 7, 10}};

/// Of one sensor of version 2: 96 shots every 480 us, 50 ms a frame.
std::string lvx2_packages(std::uint32_t id, std::size_t frame, std::int64_t begins_ns, std::uint8_t time_type) {
  std::string packages;
  for (std::size_t i = (frame * 50'000 + 479) / 480; i < ((frame + 1) * 50'000 + 479) / 480; ++i)
    packages +=
        lvx2_package(id, time_type, 1, static_cast<std::uint64_t>(begins_ns) + 480'000 * i, numbered_shots(96 * i, 96));
  return packages;
}

std::vector<std::string> lvx2_frames(std::size_t count, std::int64_t begins_ns, std::uint8_t time_type) {
  std::vector<std::string> frames;
  for (std::size_t i = 0; i < count; ++i)
    frames.push_back(lvx2_packages(3, i, begins_ns, time_type) +
                     lvx2_package(3, time_type, 0, 1, std::string(24, 'i')) +
                     lvx2_packages(7, i, begins_ns, time_type));
  return frames;
}

drive::Session opened(const std::string& bytes, const std::string& lidar = "") {
  const TemporaryFolder folder;
  Progress progress;
  drive::TopicChoice choice;
  if (!lidar.empty()) choice["lidar"] = lidar;
  return open_session(folder.write("a.lvx2", bytes), choice, progress);
}

TEST(lvx_file, version_2_with_two_sensors) {
  const std::string bytes = lvx(-1, kTwoDevices, lvx2_frames(10, kLvxBegins_ns, 1));
  EXPECT_ERROR(opened(bytes), "47MDL1B0010008 (Livox Mid-360), 0TFDG3U99102431 (Livox HAP)");
  const drive::Session session = opened(bytes, "0TFDG3U99102431");
  EXPECT_EQ(session.format, "lidar-capture");
  EXPECT_EQ(session.lidar_name, "0TFDG3U99102431");
  EXPECT_FALSE(has_code(session.findings, "capture-cut"));
  EXPECT_FALSE(has_code(session.findings, "capture-no-date"));
  ASSERT_EQ(session.scans->size(), 5U);
  EXPECT_EQ(session.scans->name(1), "a.lvx2: 0TFDG3U99102431, scan 2");
  EXPECT_EQ(session.scans->stamp_ns(0), kLvxBegins_ns);
}

TEST(lvx_file, times_of_shots_follow_from_those_of_packages) {
  const TemporaryFolder folder;
  Progress progress;
  const drive::Session session = open_session(
      folder.write("a.lvx2", lvx(-1, {kTwoDevices[0]},
                                 {lvx2_packages(3, 0, kLvxBegins_ns, 1), lvx2_packages(3, 1, kLvxBegins_ns, 1),
                                  lvx2_packages(3, 2, kLvxBegins_ns, 1), lvx2_packages(3, 3, kLvxBegins_ns, 1)})),
      progress);
  ASSERT_EQ(session.scans->size(), 2U);
  EXPECT_TRUE(session.lidar_name.empty()) << "the only one";
  const cloud::PointCloud cloud = session.scans->load(0);
  ASSERT_GT(cloud.size(), 19'000U);
  for (std::size_t i = 0; i < cloud.size(); i += 777) {
    EXPECT_NEAR(cloud.time_from_stamp_s[i], 5e-6 * static_cast<double>(i), 2e-8);
    EXPECT_NEAR(cloud.points[i].x(), 1.0 + 1e-3 * static_cast<double>(i), 1e-5);
  }
}

/// An Avia: 96 shots every 400 us, with an IMU's packet in between.
std::vector<std::string> lvx11_frames(std::size_t count) {
  std::vector<std::string> frames;
  for (std::size_t f = 0; f < count; ++f) {
    std::string packages;
    for (std::size_t i = 125 * f; i < 125 * (f + 1); ++i) {
      const std::string time = little(static_cast<std::uint64_t>(kLvxBegins_ns) + 400'000 * i, 8);
      packages += little(0, 1) + sdk1_packet(1, 2, time, numbered_shots(96 * i, 96));
      if (i % 12 == 0) packages += little(0, 1) + sdk1_packet(1, 6, time, std::string(24, 'i'));
    }
    frames.push_back(packages);
  }
  return frames;
}

TEST(lvx_file, version_1_1_keeps_packets_as_they_were_sent) {
  const drive::Session session = opened(lvx(1, {{"1HDDG8M00100191", 0, 7}}, lvx11_frames(6)));
  ASSERT_EQ(session.scans->size(), 3U);
  EXPECT_EQ(session.scans->stamp_ns(1), kLvxBegins_ns + 100'000'000);
  EXPECT_FALSE(has_code(session.findings, "capture-cut"));
  EXPECT_FALSE(has_code(session.findings, "lvx-frames"));
}

TEST(lvx_file, version_1_0_has_points_in_metres) {
  std::vector<std::string> frames;
  for (std::size_t f = 0; f < 4; ++f) {
    std::string packages;
    for (std::size_t i = 50 * f; i < 50 * (f + 1); ++i)
      packages += little(0, 1) + sdk1_packet(1, 0, little(static_cast<std::uint64_t>(kLvxBegins_ns) + 1'000'000 * i, 8),
                                             repeated(metres(1.5f, -2.25f, 0.125f, 9), 100));
    frames.push_back(packages);
  }
  const TemporaryFolder folder;
  Progress progress;
  const drive::Session session =
      open_session(folder.write("a.lvx", lvx(0, {{"0TFDFCE00502751", 0, 1}}, frames)), progress);
  ASSERT_EQ(session.scans->size(), 2U);
  const cloud::PointCloud cloud = session.scans->load(1);
  ASSERT_EQ(cloud.size(), 10'000U);
  EXPECT_EQ(cloud.points[5], Eigen::Vector3f(1.5f, -2.25f, 0.125f));
  EXPECT_NEAR(cloud.time_from_stamp_s[5], 50e-6, 1e-9);
}

TEST(lvx_file, a_recording_that_ends_early_is_used_as_far_as_it_goes) {
  const std::string whole = lvx(1, {{"1HDDG8M00100191", 0, 7}}, lvx11_frames(6));
  const drive::Session cut = opened(whole.substr(0, whole.size() - 1'000));
  EXPECT_EQ(said_of(cut.findings, "capture-cut"), "The capture ends within a packet: the last 363 bytes are not used.");
  EXPECT_EQ(cut.scans->size(), 3U);
  std::string damaged = whole;
  damaged.replace(whole.size() / 2, 60'000, std::string(60'000, 'x'));
  const drive::Session torn = opened(damaged);
  EXPECT_TRUE(has_code(torn.findings, "lvx-frames") || has_code(torn.findings, "capture-cut"));
  std::string package = whole;
  package[24 + 5 + 59 + 24 + 1] = 4;  // the version of the first packet
  EXPECT_EQ(said_of(opened(package).findings, "lvx-frames"),
            "1 frame of the recording is damaged and used as far as it is whole.");
}

TEST(lvx_file, times_without_a_date_are_told) {
  const std::string bytes =
      lvx(-1, {kTwoDevices[0]}, {lvx2_packages(3, 0, 5'000'000'000, 0), lvx2_packages(3, 1, 5'000'000'000, 0)});
  EXPECT_TRUE(contains(said_of(opened(bytes).findings, "capture-no-date"), "count from when it was switched on"));
}

TEST(lvx_file, times_from_before_a_clock_was_found_are_left_out) {
  std::vector<std::string> frames;
  for (std::size_t i = 0; i < 10; ++i)
    frames.push_back(i < 4 ? lvx2_packages(3, i, 5'000'000'000, 0) : lvx2_packages(3, i, kLvxBegins_ns, 1));
  const drive::Session session = opened(lvx(-1, {kTwoDevices[0]}, frames));
  EXPECT_TRUE(contains(said_of(session.findings, "capture-no-date"), "The times of 417 of 1042 packets count from"))
      << said_of(session.findings, "capture-no-date");
  ASSERT_EQ(session.scans->size(), 3U);
  EXPECT_NEAR(1e-9 * static_cast<double>(session.scans->stamp_ns(0) - kLvxBegins_ns), 0.2, 1e-3);
}

TEST(lvx_file, what_is_none_is_refused_with_its_place) {
  const std::string whole = lvx(-1, kTwoDevices, lvx2_frames(2, kLvxBegins_ns, 1));
  EXPECT_ERROR(opened(whole.substr(0, 40)), "a.lvx2: byte 29");
  std::string version = whole;
  version[16] = 3;
  EXPECT_ERROR(opened(version), "of version 3.0, which is not known");
  EXPECT_ERROR(opened(lvx(-1, kTwoDevices, {})), "without points");
  const TemporaryFolder folder;
  EXPECT_TRUE(is_capture(folder.write("a.bin", whole)));
  EXPECT_FALSE(is_lvx(folder.write("b.bin", "livox")));
  EXPECT_FALSE(is_lvx(folder.path() / "missing"));
}

}  // namespace
}  // namespace remount::formats
