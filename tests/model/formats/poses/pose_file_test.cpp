#include "model/formats/poses/pose_file.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "algorithms/messages/render.h"
#include "model/formats/session_readers.h"
#include "tests/model/formats/temporary_folder.h"
#include "tests/support/findings.h"

namespace remount::formats {
namespace {

std::string apollo_lines(int count, const std::string& type = "56") {
  std::string text;
  for (int i = 0; i < count; ++i) {
    char line[200];
    const double half = 0.01 * i;
    std::snprintf(line, sizeof line, "%.3f,%s,%.9f,0,0,%.9f,%.3f,4405000.5,31.25\n", 1600000000.0 + 0.1 * i,
                  type.c_str(), std::cos(half), std::sin(half), 586000.0 + 0.5 * i);
    text += line;
  }
  return text;
}

// The row with more would be a pose with other numbers: its quaternion is one, too.
TEST(pose_file, rows_with_more_fields_than_the_others_are_broken) {
  const TemporaryFolder folder;
  const std::string rows = "1.0 5 6 1 0 0 0 1\n1.1 5 6 1 0 0 0 1\n1.2 0 5 6 1 0 0 0 1\n1.3 5 6 1 0 0 0 1\n";
  for (const std::string& names : {std::string(), std::string("# t x y z qx qy qz qw\n")}) {
    std::vector<drive::Finding> findings;
    const auto poses = read_pose_file(folder.write("a.txt", names + rows), PoseFormat::Tum, findings);
    ASSERT_EQ(poses.size(), 3U) << names;
    for (const motion::StampedPose& pose : poses) EXPECT_EQ(pose.pose.translation(), Eigen::Vector3d(5, 6, 1));
    EXPECT_TRUE(contains(testing::said_of(findings, "bad-poses"), "has 9 fields, expected 8")) << names;
  }
  std::string commas = rows;
  std::ranges::replace(commas, ' ', ',');
  std::vector<drive::Finding> findings;
  EXPECT_EQ(read_pose_file(folder.write("b.csv", commas), PoseFormat::EthCsv, findings).size(), 3U);
  std::string ended;  // a separator at the end parts nothing
  for (const char c : commas) ended += c == '\n' ? std::string(",\n") : std::string(1, c);
  EXPECT_EQ(read_pose_file(folder.write("c.csv", ended), PoseFormat::EthCsv, findings).size(), 3U);
  // More than the names, and all alike: columns behind the named ones.
  EXPECT_EQ(read_pose_file(folder.write("d.txt", "# t x y z qx qy qz qw\n1.0 5 6 1 0 0 0 1 9\n1.1 5 6 1 0 0 0 1 9\n"),
                           PoseFormat::Tum, findings)
                .size(),
            2U);
}

TEST(pose_file, apollo_odometry_with_and_without_its_header) {
  const TemporaryFolder folder;
  std::vector<drive::Finding> findings;
  const auto bare = folder.write("bare.csv", apollo_lines(20));
  const auto named = folder.write("named.csv", "timestamp,position_type,qw,qx,qy,qz,x,y,z\n" + apollo_lines(20));
  for (const auto& path : {bare, named}) {
    ASSERT_EQ(recognise_pose_file(path), PoseFormat::ApolloCsv) << path;
    const std::vector<motion::StampedPose> poses = read_pose_file(path, PoseFormat::ApolloCsv, findings);
    ASSERT_EQ(poses.size(), 20U);
    EXPECT_EQ(poses[3].stamp_ns, 1'600'000'000'300'000'000);
    EXPECT_NEAR(poses[3].pose.translation().x(), 586001.5, 1e-9);
    EXPECT_NEAR(yaw_pitch_roll_from_rotation(poses[3].pose.linear()).yaw_rad, 0.06, 1e-8);
  }
  const auto moved = folder.write("moved.csv", "x,y,z,qx,qy,qz,qw,position_type,timestamp\n1,2,3,0,0,0,1,56,100.5\n");
  ASSERT_EQ(recognise_pose_file(moved), PoseFormat::ApolloCsv);
  const std::vector<motion::StampedPose> poses = read_pose_file(moved, PoseFormat::ApolloCsv, findings);
  EXPECT_EQ(poses.at(0).stamp_ns, 100'500'000'000);
  EXPECT_EQ(poses.at(0).pose.translation(), Eigen::Vector3d(1, 2, 3));
}

TEST(pose_file, apollo_positions_that_are_not_fixed_and_damaged_lines_are_named) {
  const TemporaryFolder folder;
  std::vector<drive::Finding> findings;
  const auto path =
      folder.write("odometry.csv", apollo_lines(10) + "1600000001.5,x,1,0,0,0,1,2,3\n1600000002,56,2,0,0,0,1,2,3\n");
  EXPECT_EQ(read_pose_file(path, PoseFormat::ApolloCsv, findings).size(), 10U);
  ASSERT_FALSE(findings.empty());
  EXPECT_EQ(findings[0].code, "bad-poses");
  EXPECT_TRUE(contains(english(findings[0].explanation), "odometry.csv:11: 'x' is no position type"))
      << english(findings[0].explanation);
  findings.clear();
  read_pose_file(folder.write("float.csv", apollo_lines(10, "34")), PoseFormat::ApolloCsv, findings);
  bool told = false;
  for (const drive::Finding& finding : findings) told = told || finding.code == "rtk-lost";
  EXPECT_TRUE(told);
  EXPECT_EQ(recognise_pose_file(folder.write("other.csv", "1,2,3,4,5,6,7,8,9\n")), std::nullopt)
      << "nine numbers are no odometry without a unit quaternion";
}

TEST(pose_file, apollo_odometry_is_an_ins_with_axes_right_forward_up) {
  const TemporaryFolder folder;
  folder.write("ins_odometry.csv", apollo_lines(30));
  std::string lidar;
  for (int i = 0; i < 30; ++i)
    lidar +=
        std::to_string(1600000000 + i / 10) + "." + std::to_string(i % 10) + " " + std::to_string(i) + " 0 0 0 0 0 1\n";
  folder.write("lidar.txt", lidar);
  Progress progress;
  for (const bool declared : {false, true}) {
    if (declared)
      folder.write("session.yaml",
                   "format: remount-session/1\nname: a\nlidar_poses: {file: lidar.txt, format: tum}\nins_poses: {file: "
                   "ins_odometry.csv, format: apollo-csv}\n");
    const drive::Session session = open_session(folder.path(), progress);
    EXPECT_EQ(session.ins_axes, drive::InsAxes::RightForwardUp) << session.format;
    EXPECT_EQ(session.world_from_ins.size(), 30U);
    EXPECT_EQ(session.odometry_from_lidar.size(), 30U);
  }
}

}  // namespace
}  // namespace remount::formats
