// Sessions in the layout of KITTI's raw data.
#include "model/formats/sessions/kitti_raw_reader.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <stop_token>

#include "algorithms/messages/render.h"
#include "messages/stages.h"
#include "model/formats/sessions/session_reader.h"
#include "tests/model/formats/reader_fixtures.h"
#include "tests/model/formats/sessions/kitti_fixture.h"
#include "tests/model/formats/temporary_folder.h"

namespace remount::formats {
namespace {

TEST(kitti_raw_reader, angles_in_degrees_are_refused) {
  const TemporaryFolder folder;
  write_kitti(folder, "a_sync");
  for (int i = 1; i < 4; ++i)
    folder.write("a_sync/oxts/data/000000000" + std::to_string(i) + ".txt", oxts(49.0 + 1e-6 * i, 40.0 * i));
  EXPECT_ERROR(open(folder.path() / "a_sync"), "yaw reaches 120.000000, more than a turn in radians");
}

TEST(kitti_raw_reader, opens_a_drive_from_any_parent) {
  const TemporaryFolder folder;
  write_kitti(folder, "2011_09_26/2011_09_26_drive_0001_sync");
  folder.write("2011_09_26/calib_imu_to_velo.txt", "calib_time: 25-May-2012\nR: 1 0 0 0 1 0 0 0 1\nT: -0.8 0.3 -0.8\n");
  for (const char* below :
       {"", "2011_09_26", "2011_09_26/2011_09_26_drive_0001_sync", "2011_09_26/2011_09_26_drive_0001_sync/"}) {
    const drive::Session session = open(folder.path() / below);
    EXPECT_EQ(session.format, "kitti-raw");
    EXPECT_EQ(session.name, "2011_09_26_drive_0001_sync") << below;
    ASSERT_EQ(session.ins.size(), 4u);
    EXPECT_EQ(session.ins[1].stamp_ns, 1'317'042'145'100'000'000);
    EXPECT_DOUBLE_EQ(session.ins[1].sigma.position_enu_m.y(), 0.05);
    ASSERT_TRUE(session.nominal_ins_from_lidar);
    EXPECT_LT((session.nominal_ins_from_lidar->translation() - Eigen::Vector3d(0.8, -0.3, 0.8)).norm(), 1e-12);
  }
}

TEST(kitti_raw_reader, reading_its_ins_files_can_be_cancelled) {
  const TemporaryFolder folder;
  write_kitti(folder, "a_sync");
  std::stop_source stop;
  std::size_t reports = 0;
  Progress progress(stop.get_token(), [&](const ProgressUpdate& update) {
    if (update.stage != say::stage_reading_ins) return;
    ++reports;
    stop.request_stop();
  });
  const drive::Session session = KittiRawReader().open(folder.path() / "a_sync", progress);
  EXPECT_EQ(reports, 1U);
  EXPECT_TRUE(session.ins.empty()) << "cancelled before the first";
  EXPECT_EQ(session.scans, nullptr);
}

TEST(kitti_raw_reader, several_drives_are_listed) {
  const TemporaryFolder folder;
  write_kitti(folder, "d/a_sync");
  write_kitti(folder, "d/b_sync");
  EXPECT_ERROR(open(folder.path()), "holds 2 drives");
  EXPECT_ERROR(open(folder.path()), "b_sync");
}

TEST(kitti_raw_reader, bad_files_become_findings_and_the_rest_opens) {
  const TemporaryFolder folder;
  write_kitti(folder, "a_sync");
  folder.write("a_sync/oxts/data/0000000001.txt", "49.0 8.4 115\n");
  folder.write("a_sync/oxts/data/0000000003.txt", oxts(249.0, 0));
  std::filesystem::remove(folder.path() / "a_sync/velodyne_points/data/0000000002.bin");
  folder.write("a_sync/velodyne_points/data/0000000003.bin", "abc");
  const drive::Session session = open(folder.path() / "a_sync");
  EXPECT_EQ(session.ins.size(), 2u);
  ASSERT_NE(find(session, "bad-ins"), nullptr);
  EXPECT_TRUE(contains(english(find(session, "bad-ins")->explanation), "0000000001.txt:1: has 3 numbers, expected 30"));
  ASSERT_NE(find(session, "missing-scans"), nullptr);
  ASSERT_EQ(session.scans->size(), 3u);
  EXPECT_EQ(session.scans->load(0).size(), 2u);
  EXPECT_ERROR(session.scans->load(2), "0000000003.bin: holds 3 bytes");
  EXPECT_ERROR(session.scans->load(3), "does not exist");
}

TEST(kitti_raw_reader, extract_keeps_its_own_stamps_and_takes_the_period_of_a_turn) {
  const TemporaryFolder folder;
  write_kitti(folder, "a_extract");
  std::string start, end, stamps;
  for (int i = 0; i < 4; ++i) {
    start += "2011-09-26 13:02:25." + std::to_string(i) + "01000000\n";
    stamps += "2011-09-26 13:02:25." + std::to_string(i) + "52000000\n";
    end += "2011-09-26 13:02:25." + std::to_string(i) + "99500000\n";
    std::filesystem::remove(folder.path() / ("a_extract/velodyne_points/data/000000000" + std::to_string(i) + ".bin"));
    folder.write("a_extract/velodyne_points/data/000000000" + std::to_string(i) + ".txt", "1 2 3 0.5\n");
  }
  folder.write("a_extract/velodyne_points/timestamps.txt", stamps);
  folder.write("a_extract/velodyne_points/timestamps_start.txt", start);
  folder.write("a_extract/velodyne_points/timestamps_end.txt", end);
  const drive::Session session = open(folder.path());
  EXPECT_EQ(session.scans->stamp_ns(0), 1'317'042'145'052'000'000);
  EXPECT_EQ(session.scans->load(1).size(), 1u);
  EXPECT_NEAR(session.sweep.period_s, 0.0985, 1e-9);
  EXPECT_FALSE(session.sweep.clockwise);
  EXPECT_TRUE(session.sweep.certain);
  EXPECT_FALSE(session.sweep.direction_known);
}

TEST(kitti_raw_reader, sync_goes_by_stamps_where_numbers_do_not_belong_together) {
  const auto stamp = [](int i) { return "2011-09-26 13:02:25." + std::to_string(i) + "00000000\n"; };
  const TemporaryFolder folder;
  write_kitti(folder, "a_sync");
  EXPECT_EQ(find(open(folder.path() / "a_sync"), "stamps-not-by-number"), nullptr);
  // The first sample of the INS is gone, and those that are left are numbered anew.
  std::string stamps;
  for (int i = 0; i < 3; ++i) {
    folder.write("a_sync/oxts/data/000000000" + std::to_string(i) + ".txt", oxts(49.0 + 1e-6 * (i + 1), 0.1 * (i + 1)));
    stamps += stamp(i + 1);
  }
  std::filesystem::remove(folder.path() / "a_sync/oxts/data/0000000003.txt");
  folder.write("a_sync/oxts/timestamps.txt", stamps);
  const drive::Session fewer = open(folder.path() / "a_sync");
  const drive::Finding* finding = find(fewer, "stamps-not-by-number");
  ASSERT_NE(finding, nullptr);
  EXPECT_EQ(finding->severity, drive::Severity::Warning);
  EXPECT_TRUE(contains(english(finding->explanation), "4 stamps of scans and 3 of the INS"))
      << english(finding->explanation);
  ASSERT_EQ(fewer.ins.size(), 3U);
  ASSERT_EQ(fewer.scans->size(), 4U);
  EXPECT_EQ(fewer.scans->stamp_ns(1), fewer.ins[0].stamp_ns);
  // As many of both, but not the same: a scan was taken out in front, and one of the INS at the end.
  write_kitti(folder, "b_sync");
  stamps.clear();
  for (int i = 0; i < 4; ++i) stamps += stamp(i + 1);
  folder.write("b_sync/velodyne_points/timestamps.txt", stamps);
  const drive::Session shifted = open(folder.path() / "b_sync");
  ASSERT_NE(find(shifted, "stamps-not-by-number"), nullptr);
  EXPECT_EQ(shifted.scans->stamp_ns(0), shifted.ins[1].stamp_ns);
}

TEST(kitti_raw_reader, real_drives) {
  SKIP_WITHOUT(shared_data() / "kitti");
  for (const char* drive : {"00", "05", "07", "10"}) {
    const drive::Session session = open(shared_data() / "kitti" / drive);
    EXPECT_EQ(session.ins.size(), 10u);
    ASSERT_EQ(session.scans->size(), 10u);
    EXPECT_GT(session.scans->load(9).size(), 100'000u);
    EXPECT_TRUE(session.findings.empty()) << english(session.findings[0].explanation);
  }
  EXPECT_ERROR(open(shared_data() / "kitti"), "holds 4 drives");
}

}  // namespace
}  // namespace remount::formats
