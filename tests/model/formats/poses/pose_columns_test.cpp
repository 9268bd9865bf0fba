// Files of poses whose header names the order of columns and the unit of times, and those that have none.
#include "model/formats/poses/pose_columns.h"

#include <gtest/gtest.h>

#include "algorithms/messages/render.h"
#include "model/formats/poses/pose_file.h"
#include "tests/model/formats/temporary_folder.h"

namespace remount::formats {
namespace {

/// One pose every tenth of a second, as one line of text each.
struct OnePose {
  int i;
  double x() const { return 0.5 * i; }
  double half_rad() const { return 0.01 * i; }
};

/// @param order what stands in each column: t, n (number of the line), x, y, z, a b c d (quaternion x y z w), v (else)
std::string pose_lines_in(const std::string& order, char separator, std::int64_t time_unit_ns, std::int64_t first_ns) {
  std::string text;
  for (int i = 0; i < 40; ++i) {
    const OnePose pose{i};
    std::string line;
    for (const char column : order) {
      char field[64];
      const std::int64_t stamp_ns = first_ns + i * 100'000'000LL;
      const double value = column == 'x'   ? pose.x()
                           : column == 'y' ? 2.0
                           : column == 'z' ? 3.0
                           : column == 'c' ? std::sin(pose.half_rad())
                           : column == 'd' ? std::cos(pose.half_rad())
                           : column == 'v' ? 77.0
                                           : 0.0;
      if (column == 'n')
        std::snprintf(field, sizeof field, "%d", i);
      else if (column == 't' && time_unit_ns == 1'000'000'000)
        std::snprintf(field, sizeof field, "%lld.%09lld", static_cast<long long>(stamp_ns / time_unit_ns),
                      static_cast<long long>(stamp_ns % time_unit_ns));
      else if (column == 't')
        std::snprintf(field, sizeof field, "%lld", static_cast<long long>(stamp_ns / time_unit_ns));
      else
        std::snprintf(field, sizeof field, "%.12f", value);
      if (!line.empty()) line += separator;
      line += field;
    }
    text += line + "\n";
  }
  return text;
}

void expect_poses(const std::string& text, std::int64_t first_ns, std::size_t findings_expected = 0) {
  const TemporaryFolder folder;
  const auto path = folder.write("poses.txt", text);
  const auto format = recognise_pose_file(path);
  ASSERT_TRUE(format) << text.substr(0, 200);
  std::vector<drive::Finding> findings;
  const std::vector<motion::StampedPose> poses = read_pose_file(path, *format, findings);
  ASSERT_EQ(poses.size(), 40u);
  EXPECT_EQ(findings.size(), findings_expected) << (findings.empty() ? "" : english(findings[0].explanation));
  for (const int i : {0, 7, 39}) {
    const motion::StampedPose& pose = poses[static_cast<std::size_t>(i)];
    EXPECT_EQ(pose.stamp_ns, first_ns + i * 100'000'000LL);
    EXPECT_LT((pose.pose.translation() - Eigen::Vector3d(0.5 * i, 2.0, 3.0)).norm(), 1e-9);
    EXPECT_NEAR(yaw_pitch_roll_from_rotation(pose.pose.linear()).yaw_rad, 0.02 * i, 1e-8);
  }
}

constexpr std::int64_t kThen_ns = 1'520'530'308'189'680'000, kS = 1'000'000'000, kMs = 1'000'000, kUs = 1'000, kNs = 1;

TEST(pose_columns, are_obeyed_as_the_header_names_them) {
  const std::pair<const char*, const char*> with_blanks[] = {
      {"# timestamp(s) tx ty tz qx qy qz qw\n", "txyzabcd"},
      {"#timestamp tx ty tz qw qx qy qz\n", "txyzdabc"},
      {"# ground truth\n# timestamp [s] x [m] y [m] z [m] qw qx qy qz\n", "txyzdabc"},
      {"time qw qx qy qz x y z\n", "tdabcxyz"},
      {"#index timestamp px py pz qx qy qz qw\n", "ntxyzabcd"}};
  for (const auto& [header, order] : with_blanks)
    expect_poses(header + pose_lines_in(order, ' ', kS, kThen_ns), kThen_ns);
  const std::pair<const char*, const char*> with_commas[] = {
      {"#timestamp [s], p_RS_R_x [m], p_RS_R_y [m], p_RS_R_z [m], q_RS_w [], q_RS_x [], q_RS_y [], q_RS_z []\n",
       "txyzdabc"},
      {"timestamp,tx,ty,tz,qx,qy,qz,qw\n", "txyzabcd"},
      {"num,t,x,y,z,qx,qy,qz,qw\n", "ntxyzabcd"},
      {"Time,Position.X,Position.Y,Position.Z,Orientation.W,Orientation.X,Orientation.Y,Orientation.Z,Speed\n",
       "txyzdabcv"},
      {"qw,qx,qy,qz,t_x,t_y,t_z,timestamp\n", "dabcxyzt"},
      {"t,位置x,位置y,位置z,qx,qy,qz,qw\n", "txyzabcd"},
      {"t\xc2\xa0,x\xc2\xa0,y,z,qx,qy,qz,qw\xc2\xa0\n", "txyzabcd"}};  // blanks that do not break
  for (const auto& [header, order] : with_commas)
    expect_poses(header + pose_lines_in(order, ',', kS, kThen_ns), kThen_ns);
}

TEST(pose_columns, of_euroc_and_of_ros_messages_are_known_among_others) {
  expect_poses(
      "#timestamp, p_RS_R_x [m], p_RS_R_y [m], p_RS_R_z [m], q_RS_w [], q_RS_x [], q_RS_y [], q_RS_z [], v_RS_R_x [m "
      "s^-1], v_RS_R_y [m s^-1], v_RS_R_z [m s^-1], b_w_RS_S_x [rad s^-1]\n" +
          pose_lines_in("txyzdabcvvvv", ',', kNs, kThen_ns),
      kThen_ns, 1);
  expect_poses(
      "%time,field.header.seq,field.header.stamp,field.pose.pose.position.x,field.pose.pose.position.y,"
      "field.pose.pose.position.z,field.pose.pose.orientation.x,field.pose.pose.orientation.y,"
      "field.pose.pose.orientation.z,field.pose.pose.orientation.w,field.twist.twist.linear.x\n" +
          pose_lines_in("vntxyzabcdv", ',', kNs, kThen_ns),
      kThen_ns, 1);
}

TEST(pose_columns, units_of_times_are_those_of_the_header_or_of_their_size) {
  for (const auto& [unit_ns, name] : {std::pair{kNs, "ns"}, {kUs, "us"}, {kUs, "\xc2\xb5s"}, {kMs, "ms"}}) {
    const std::int64_t first_ns = kThen_ns / kMs * kMs;
    expect_poses(pose_lines_in("txyzabcd", ' ', unit_ns, first_ns), first_ns, 1);
    expect_poses("# timestamp [" + std::string(name) + "] tx ty tz qx qy qz qw\n" +
                     pose_lines_in("txyzabcd", ' ', unit_ns, first_ns),
                 first_ns);
    expect_poses(
        "time_" + std::string(name) + ",x,y,z,qx,qy,qz,qw\n" + pose_lines_in("txyzabcd", ',', unit_ns, 5'000'000'000),
        5'000'000'000);
  }
  expect_poses(pose_lines_in("txyzabcd", ' ', kNs, 0), 0, 1);  // since the start of the drive
  expect_poses(pose_lines_in("ntxyzabcd", ',', kS, kThen_ns), kThen_ns);
  expect_poses(pose_lines_in("ntxyzabcd", ' ', kNs, kThen_ns), kThen_ns, 1);
}

TEST(pose_columns, units_by_size_are_those_in_which_steps_are_possible) {
  for (const double first : {3.1e8, 1e9, 4e9}) {  // in which seconds would be of 1979 to 2096
    EXPECT_EQ(unit_of_stamps_ns({first, first + 1e8, first + 2e8}), kNs) << first;
    EXPECT_EQ(unit_of_stamps_ns({first, first + 1e5, first + 2e5}), kUs) << first;
    EXPECT_EQ(unit_of_stamps_ns({first, first + 0.1, first + 0.2}), kS) << first;
    EXPECT_EQ(unit_of_stamps_ns({first, first, first}), kS) << first;
  }
  EXPECT_EQ(unit_of_stamps_ns({1e12, 1e12 + 1e8, 1e12 + 2e8}), kNs) << "a quarter of an hour, not 2001 in ms";
  EXPECT_EQ(unit_of_stamps_ns({1.7e18, 1.7e18 + 1024.0, 1.7e18 + 1e8}), kNs) << "a burst at the begin";
  expect_poses(pose_lines_in("txyzabcd", ' ', kNs, 1'000'000'000), 1'000'000'000, 1);
}

TEST(pose_columns, units_that_several_sizes_allow_are_not_guessed) {
  EXPECT_EQ(unit_of_stamps_ns({0.0, 1e6, 2e6}), std::nullopt);  // milliseconds of ns, or seconds of us
  EXPECT_EQ(unit_of_stamps_ns({0.0, 0.1, 0.2}), kS);
  EXPECT_EQ(unit_of_stamps_ns({10.0, 11.0, 12.0}), kS);
  EXPECT_EQ(unit_of_stamps_ns({}), std::nullopt);
  const TemporaryFolder folder;
  const auto path = folder.write(
      "poses.txt", "0 1 2 3 0 0 0 1\n1000000 1 2 3 0 0 0 1\n2000000 1 2 3 0 0 0 1\n3000000 1 2 3 0 0 0 1\n");
  std::vector<drive::Finding> findings;
  EXPECT_ERROR(read_pose_file(path, PoseFormat::Tum, findings), "the unit of its times cannot be told");
}

TEST(pose_columns, are_looked_for_in_whatever_has_letters) {
  for (const char* numbers : {"", "1 2 3", "-1.5e+3,2E-4\t;7", "2023-11-14 22:00:05", "# 1 2 / 3"})
    EXPECT_FALSE(holds_letters(numbers)) << numbers;
  for (const char* names : {"q0", "1 phi", "lambda", "纬度", "e w", "x", "nan"})
    EXPECT_TRUE(holds_letters(names)) << names;
}

TEST(pose_columns, that_lack_something_are_no_header) {
  EXPECT_FALSE(named_pose_columns("# x y z of the base, in metres"));
  EXPECT_FALSE(named_pose_columns("timestamp,tx,ty,tz,yaw,pitch,roll"));
  EXPECT_FALSE(named_pose_columns("timestamp,tx,ty,tz,qx,qy,qz"));
  EXPECT_FALSE(named_pose_columns(""));
  EXPECT_FALSE(named_pose_columns("1 2 3 4 5 6 7 8"));
}

}  // namespace
}  // namespace remount::formats
