// Sessions in the layout of KITTI's odometry benchmark.
#include "model/formats/sessions/kitti_odometry_reader.h"

#include <gtest/gtest.h>

#include <cmath>
#include <iostream>

#include "algorithms/geometry/rotation.h"
#include "algorithms/messages/render.h"
#include "model/formats/files/number_text.h"
#include "tests/model/formats/reader_fixtures.h"
#include "tests/model/formats/temporary_folder.h"

namespace remount::formats {
namespace {

using Eigen::AngleAxisd;
using Eigen::Vector3d;

std::string row_of(const Eigen::Matrix3d& rotation, const Vector3d& translation) {
  std::string row;
  for (int i = 0; i < 12; ++i)
    (row += i == 0 ? "" : " ") += exact_text(i % 4 == 3 ? translation[i / 4] : rotation(i / 4, i % 4));
  return row + "\n";
}

/// Tr of sequence 00, as it is published.
constexpr const char* kPublishedTr =
    "Tr: 4.276802385584e-04 -9.999672484946e-01 -8.084491683471e-03 -1.198459927713e-02 -7.210626507497e-03 "
    "8.081198471645e-03 -9.999413164504e-01 -5.403984729748e-02 9.999738645903e-01 4.859485810390e-04 "
    "-7.206933692422e-03 -2.921968648686e-01\n";

constexpr double kTurn_rad = 0.1;

/// Four poses of the camera: at the start, turned right, nose up, leaning to the right; each 2 m further ahead.
std::string four_poses() {
  const Vector3d right = Vector3d::UnitX(), down = Vector3d::UnitY(), ahead = Vector3d::UnitZ();
  std::string rows = row_of(Eigen::Matrix3d::Identity(), Vector3d::Zero());
  int i = 0;
  for (const Vector3d& axis : {down, right, ahead})
    rows += row_of(AngleAxisd(kTurn_rad, axis).toRotationMatrix(), Vector3d(0.25, -0.5, 2.0 * ++i));
  return rows;
}

void write_sequence(const TemporaryFolder& folder, const std::string& name = "00",
                    const std::string& poses = four_poses()) {
  const std::string sequence = "dataset/sequences/" + name;
  for (int i = 0; i < 4; ++i)
    folder.write(sequence + "/velodyne/00000" + std::to_string(i) + ".bin", std::string(32, '\x3f'));
  folder.write(sequence + "/times.txt", "0.000000e+00\n1.036224e-01\n2.072530e-01\n3.108763e-01\n");
  folder.write(sequence + "/calib.txt",
               std::string("P0: 7.1e+02 0 6e+02 0 0 7.1e+02 1.8e+02 0 0 0 1 0\n") + kPublishedTr);
  if (!poses.empty()) folder.write("dataset/poses/" + name + ".txt", poses);
}

TEST(kitti_odometry_reader, a_camera_that_turns_right_nose_up_and_leans_right_does_so_in_the_axes_of_a_vehicle) {
  const TemporaryFolder folder;
  write_sequence(folder);
  const drive::Session session = open(folder.path() / "dataset/sequences/00");
  EXPECT_EQ(session.format, "kitti-odometry");
  EXPECT_EQ(session.name, "00");
  EXPECT_EQ(session.ins_axes, drive::InsAxes::ForwardLeftUp);
  EXPECT_EQ(session.scan_timing, drive::ScanTiming::Instant);
  ASSERT_EQ(session.world_from_ins.size(), 4U);
  EXPECT_EQ(session.world_from_ins[1].stamp_ns, 103'622'400);
  EXPECT_EQ(session.scans->stamp_ns(1), 103'622'400);
  // Left is minus right, up is minus down.
  const Vector3d place = session.world_from_ins[1].pose.translation();
  EXPECT_LT((place - Vector3d(2.0, -0.25, 0.5)).norm(), 1e-12) << place.transpose();
  const YawPitchRoll right = yaw_pitch_roll_from_rotation(session.world_from_ins[1].pose.linear());
  const YawPitchRoll nose_up = yaw_pitch_roll_from_rotation(session.world_from_ins[2].pose.linear());
  const YawPitchRoll leans_right = yaw_pitch_roll_from_rotation(session.world_from_ins[3].pose.linear());
  EXPECT_NEAR(right.yaw_rad, -kTurn_rad, 1e-12) << "yaw counts to the left";
  EXPECT_NEAR(nose_up.pitch_rad, -kTurn_rad, 1e-12) << "positive pitch lowers the nose";
  EXPECT_NEAR(leans_right.roll_rad, kTurn_rad, 1e-12) << "positive roll lowers the right side";
}

TEST(kitti_odometry_reader, tr_is_the_nominal_and_puts_the_lidar_where_the_car_has_it) {
  const TemporaryFolder folder;
  write_sequence(folder);
  const drive::Session session = open(folder.path());
  ASSERT_TRUE(session.nominal_ins_from_lidar);
  const Vector3d lidar_in_camera_flu_m = session.nominal_ins_from_lidar->translation();
  const double turned_deg = radians_to_degrees(AngleAxisd(session.nominal_ins_from_lidar->linear()).angle());
  std::cout << "LiDAR at " << lidar_in_camera_flu_m.transpose() << " m, turned by " << turned_deg << " degrees\n";
  // The set-up's drawing: the LiDAR is 0.27 m behind the cameras and 0.08 m above, before the calibration.
  EXPECT_LT((lidar_in_camera_flu_m - Vector3d(-0.2921968648686, 0.01198459927713, 0.05403984729748)).norm(), 1e-12);
  EXPECT_LT(turned_deg, 1.0) << "both look ahead";
  ASSERT_NE(find(session, "nominal-found"), nullptr);
  ASSERT_NE(find(session, "poses-by-mounting"), nullptr);
  EXPECT_EQ(find(session, "poses-by-mounting")->severity, drive::Severity::Note);
}

TEST(kitti_odometry_reader, only_scans_beside_a_published_calibration_count_as_compensated) {
  const TemporaryFolder folder;
  write_sequence(folder);
  const drive::Session published = open(folder.path());
  EXPECT_EQ(published.scan_timing, drive::ScanTiming::Instant);
  EXPECT_EQ(find(published, "no-point-times"), nullptr);
  std::string other = kPublishedTr;
  other.replace(other.find("-1.198459927713e-02"), 19, "-1.198559927713e-02");
  for (const std::string& calibration : {other, std::string("P0: 1 0 0 0 0 1 0 0 0 0 1 0\n")}) {
    folder.write("dataset/sequences/00/calib.txt", calibration);
    const drive::Session session = open(folder.path());
    EXPECT_EQ(session.scan_timing, drive::ScanTiming::Unknown) << calibration;
    testing::expect_told(session.findings, "no-point-times", "is none that the benchmark published");
  }
}

TEST(kitti_odometry_reader, scans_beyond_the_times_are_counted) {
  const TemporaryFolder folder;
  write_sequence(folder);
  for (const char* name : {"000004", "000005"})
    folder.write("dataset/sequences/00/velodyne/" + std::string(name) + ".bin", std::string(32, '\x3f'));
  testing::expect_told(open(folder.path()).findings, "scans-without-stamp", "2 files have no time stamp");
}

TEST(kitti_odometry_reader, opens_from_any_parent_and_lists_several) {
  const TemporaryFolder folder;
  write_sequence(folder);
  for (const char* below : {"", "dataset", "dataset/sequences", "dataset/sequences/00", "dataset/sequences/00/"})
    EXPECT_EQ(open(folder.path() / below).world_from_ins.size(), 4U) << below;
  write_sequence(folder, "07");
  EXPECT_ERROR(open(folder.path()), "holds 2 sequences");
  EXPECT_EQ(open(folder.path() / "dataset/sequences/07").name, "07");
}

TEST(kitti_odometry_reader, poses_of_scans_are_warned_of_and_none_are_half_a_session) {
  const TemporaryFolder folder;
  write_sequence(folder, "08", "");
  const drive::Session half = open(folder.path() / "dataset/sequences/08");
  ASSERT_NE(find(half, "one-stream"), nullptr);
  EXPECT_TRUE(contains(english(find(half, "one-stream")->explanation), "poses/08.txt"));
  EXPECT_EQ(half.scans->size(), 4U);
  folder.write("dataset/sequences/08/poses.txt", four_poses());
  const drive::Session session = open(folder.path() / "dataset/sequences/08");
  EXPECT_EQ(session.world_from_ins.size(), 4U);
  ASSERT_NE(find(session, "poses-by-mounting"), nullptr);
  EXPECT_EQ(find(session, "poses-by-mounting")->severity, drive::Severity::Warning);
}

TEST(kitti_odometry_reader, without_tr_there_is_no_nominal_and_this_is_said) {
  const TemporaryFolder folder;
  write_sequence(folder);
  folder.write("dataset/sequences/00/calib.txt", "P0: 1 0 0 0 0 1 0 0 0 0 1 0\n");
  const drive::Session session = open(folder.path());
  EXPECT_FALSE(session.nominal_ins_from_lidar);
  ASSERT_NE(find(session, "no-nominal"), nullptr);
  EXPECT_TRUE(contains(english(find(session, "no-nominal")->explanation), "data_odometry_calib.zip"));
  folder.write("dataset/sequences/00/calib.txt", "Tr: 1 0 0 0 0 1\n");
  const drive::Session damaged = open(folder.path());
  ASSERT_NE(find(damaged, "nominal-unreadable"), nullptr);
  EXPECT_TRUE(contains(english(find(damaged, "nominal-unreadable")->explanation), "calib.txt:1: has 6 numbers"));
  std::filesystem::remove(folder.path() / "dataset/sequences/00/calib.txt");
  ASSERT_NE(find(open(folder.path()), "no-nominal"), nullptr);
}

TEST(kitti_odometry_reader, bad_lines_and_missing_scans_are_left_out_by_their_numbers) {
  const TemporaryFolder folder;
  std::string poses = four_poses();
  poses.replace(poses.find('\n') + 1, 3, "abc");
  write_sequence(folder, "00", poses + row_of(Eigen::Matrix3d::Identity(), Vector3d::Zero()));
  std::filesystem::remove(folder.path() / "dataset/sequences/00/velodyne/000002.bin");
  const drive::Session session = open(folder.path());
  ASSERT_EQ(session.world_from_ins.size(), 3U);
  EXPECT_EQ(session.world_from_ins[1].stamp_ns, 207'253'000) << "line 3 is of time 3";
  ASSERT_NE(find(session, "bad-poses"), nullptr);
  EXPECT_TRUE(contains(english(find(session, "bad-poses")->explanation), "00.txt:2"));
  EXPECT_NE(find(session, "poses-without-time"), nullptr);
  ASSERT_EQ(session.scans->size(), 3U);
  EXPECT_EQ(session.scans->name(2), "000003.bin");
  EXPECT_NE(find(session, "missing-scans"), nullptr);
  folder.write("dataset/poses/00.txt", "1 2 3\n");
  EXPECT_ERROR(open(folder.path()), "has 3 numbers, expected 12: a 3x4 matrix");
  folder.write("dataset/sequences/00/times.txt", "\n\n");
  EXPECT_ERROR(open(folder.path()), "holds no times");
}

}  // namespace
}  // namespace remount::formats
