#include "model/formats/session_readers.h"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <random>

#include "algorithms/geometry/rotation.h"
#include "algorithms/messages/render.h"
#include "model/formats/files/number_text.h"
#include "model/formats/files/time_stamp.h"
#include "model/formats/poses/pose_file.h"
#include "model/formats/poses/pose_pairing.h"
#include "model/formats/sessions/several_sessions.h"
#include "tests/model/formats/reader_fixtures.h"
#include "tests/model/formats/sessions/kitti_fixture.h"
#include "tests/model/formats/temporary_folder.h"

namespace remount::formats {
namespace {

TEST(session_readers, what_is_no_file_at_all_is_named) {
  const TemporaryFolder folder;
  const std::filesystem::path fifo = folder.path() / "fifo";
  ASSERT_EQ(::mkfifo(fifo.c_str(), 0600), 0);
  EXPECT_ERROR(open(fifo), "is a FIFO");
  EXPECT_ERROR(open("/dev/null"), "is a device");
  std::filesystem::create_symlink("loop", folder.path() / "loop");
  EXPECT_ERROR(open(folder.path() / "loop"), "is a symbolic link that leads nowhere");
}

// ---- OpenCalib

std::string pose_lines(int count, double scale = 1.0) {
  std::string text;
  for (int i = 0; i < count; ++i) {
    char line[256];
    std::snprintf(line, sizeof line, "2021-10-26-16-21-%02d-%03d %.9f 0 0 %d 0 %.9f 0 0 0 0 %.9f 0\n", 10 + i / 10,
                  i % 10 * 100, scale, i, scale, scale);
    text += line;
  }
  return text;
}

TEST(open_calib_reader, poses_of_both_streams) {
  const TemporaryFolder folder;
  folder.write("NovAtel-pose-lidar-time.txt", pose_lines(20));
  folder.write("top_center_lidar-enu.txt", pose_lines(20));
  folder.write("top_center_lidar-pose.txt", pose_lines(20, 1.000000458));
  folder.write("top_center_lidar/2021-10-26-16-21-10-000.pcd", "FIELDS x y z\n");
  const drive::Session session = open(folder.path());
  EXPECT_EQ(session.format, "opencalib");
  EXPECT_EQ(session.world_from_ins.size(), 20u);
  EXPECT_EQ(session.odometry_from_lidar.size(), 20u);
  EXPECT_LT((session.odometry_from_lidar[3].pose.linear() - Eigen::Matrix3d::Identity()).norm(), 1e-12);
  EXPECT_NE(find(session, "ins-file-chosen"), nullptr);
  EXPECT_NE(find(session, "lidar-poses-preferred"), nullptr);
  EXPECT_EQ(find(session, "rotation-not-orthonormal"), nullptr);
}

TEST(open_calib_reader, scans_with_a_single_pose_file) {
  const TemporaryFolder folder;
  folder.write("top_center_lidar-pose.txt", pose_lines(3));
  const std::string header = "FIELDS x y z time\nSIZE 4 4 4 4\nTYPE F F F F\nWIDTH 2\nHEIGHT 1\nDATA ascii\n";
  folder.write("pcd/2021-10-26-16-21-10-000.pcd", header + "1 2 3 0\n4 5 6 0.09\n");
  folder.write("pcd/2021-10-26-16-21-10-100.pcd", "broken");
  folder.write("pcd/2021-10-26-16-21-10-200.pcd", header + "1 2 3 0\n4 5 6 0.09\n");
  folder.write("pcd/readme.pcd", "not a stamp");
  const drive::Session session = open(folder.path());
  EXPECT_EQ(session.world_from_ins.size(), 3u);
  ASSERT_TRUE(session.scans);
  ASSERT_EQ(session.scans->size(), 3u);
  EXPECT_EQ(session.scan_timing, drive::ScanTiming::PerPoint);
  EXPECT_EQ(session.scans->stamp_ns(2), *parse_date_ns("2021-10-26-16-21-10-200"));
  EXPECT_ERROR(session.scans->load(1), "100.pcd:1");
  EXPECT_EQ(session.scans->load(2).size(), 2u);
}

TEST(open_calib_reader, rotations_that_are_none_are_left_out) {
  const TemporaryFolder folder;
  std::vector<drive::Finding> findings;
  const auto file = folder.write(
      "ins.txt", pose_lines(3) + "2021-10-26-16-22-00-000 2 0 0 0 0 2 0 0 0 0 2 0\n2021-10-26-16-22-01-000 1 2 3\n");
  EXPECT_EQ(read_pose_file(file, PoseFormat::PoseLines, findings).size(), 3u);
  ASSERT_EQ(findings.size(), 1u);
  EXPECT_TRUE(contains(english(findings[0].explanation), "2 lines cannot be used")) << english(findings[0].explanation);
  EXPECT_TRUE(contains(english(findings[0].explanation), "ins.txt:4: the nine numbers are no rotation"));
  const auto skewed = folder.write("skewed.txt", pose_lines(3, 1.01));
  EXPECT_EQ(read_pose_file(skewed, PoseFormat::PoseLines, findings).size(), 3u);
  EXPECT_EQ(findings.back().code, "rotation-not-orthonormal");
  EXPECT_ERROR(read_pose_file(folder.write("none.txt", pose_lines(3, 2.0)), PoseFormat::PoseLines, findings),
               "holds no usable pose");
}

TEST(open_calib_reader, real_data_are_exact_conjugates) {
  SKIP_WITHOUT(shared_data() / "opencalib");
  const drive::Session session = open(shared_data() / "opencalib");
  ASSERT_EQ(session.world_from_ins.size(), 1081u);
  ASSERT_EQ(session.odometry_from_lidar.size(), 1081u);
  double worst_rad = 0.0;
  for (std::size_t i = 0; i + 50 < 1081; i += 10) {
    const auto motion = [&](const std::vector<motion::StampedPose>& poses) {
      return so3_log((poses[i].pose.inverse() * poses[i + 50].pose).linear()).norm();
    };
    ASSERT_EQ(session.world_from_ins[i].stamp_ns, session.odometry_from_lidar[i].stamp_ns);
    worst_rad = std::max(worst_rad, std::abs(motion(session.world_from_ins) - motion(session.odometry_from_lidar)));
  }
  EXPECT_LT(worst_rad, 1e-5) << "equal angles of rotation, whatever X is";
}

// ---- Pose files

std::string poses(double clock_s, double yaw_offset, const char* separator, double from_s, double to_s, double step_s) {
  std::string text;
  for (double t = from_s; t < to_s; t += step_s) {
    const double yaw = 1.5 * std::sin(0.31 * t) + 0.8 * std::sin(0.83 * t + 1.0) + yaw_offset;
    char line[256];
    std::snprintf(line, sizeof line, "%.6f%s1%s2%s3%s0%s0%s%.12f%s%.12f\n", t + clock_s, separator, separator,
                  separator, separator, separator, separator, std::sin(yaw / 2), separator, std::cos(yaw / 2));
    text += line;
  }
  return text;
}

TEST(pose_session_reader, pairs_by_name_and_aligns_clocks_that_do_not_overlap) {
  const TemporaryFolder folder;
  folder.write("run_vicon.csv", "# t,x,y,z,qx,qy,qz,qw\n" + poses(0, 0.0, ",", 100, 160, 0.02));
  folder.write("run_camera.txt", poses(5000.25, 1.0, " ", 110, 150, 0.1));
  const drive::Session session = open(folder.path());
  EXPECT_EQ(session.format, "poses");
  EXPECT_EQ(session.world_from_ins.size(), 3000u);
  ASSERT_NE(find(session, "clock-aligned"), nullptr);
  EXPECT_NEAR(static_cast<double>(session.odometry_from_lidar[0].stamp_ns) * 1e-9, 110.0, 0.003);
}

TEST(pose_session_reader, clocks_that_are_declared_unsynchronised_and_agree_are_not_moved) {
  const TemporaryFolder folder;
  folder.write("run_vicon.csv", "# t,x,y,z,qx,qy,qz,qw\n" + poses(0, 0.0, ",", 100, 160, 0.02));
  folder.write("run_camera.txt", poses(0.0, 1.0, " ", 110, 150, 0.1));
  drive::Session session = open(folder.path());
  const std::int64_t first_ns = session.odometry_from_lidar[0].stamp_ns;
  align_lidar_clock(session, ClockUse::Unsynchronised);
  EXPECT_EQ(session.findings.back().code, "clock-offset") << english(session.findings.back().explanation);
  EXPECT_EQ(session.odometry_from_lidar[0].stamp_ns, first_ns);
  for (motion::StampedPose& pose : session.odometry_from_lidar) pose.stamp_ns += 50'000'000;
  align_lidar_clock(session, ClockUse::Unsynchronised);
  EXPECT_EQ(session.findings.back().code, "clock-aligned") << english(session.findings.back().explanation);
  EXPECT_NEAR(static_cast<double>(session.odometry_from_lidar[0].stamp_ns - first_ns), 0.0, 3e6);
}

TEST(pose_session_reader, clocks_that_are_centuries_apart_are_not_added_up) {
  const TemporaryFolder folder;
  folder.write("run_vicon.csv", "# t,x,y,z,qx,qy,qz,qw\n" + poses(0, 0.0, ",", 100, 160, 0.02));
  folder.write("run_camera.txt", poses(0.0, 1.0, " ", 110, 150, 0.1));
  drive::Session session = open(folder.path());
  constexpr std::int64_t kFar_ns = 7'000'000'000'000'000'000;
  for (motion::StampedPose& pose : session.world_from_ins) pose.stamp_ns += kFar_ns;
  for (motion::StampedPose& pose : session.odometry_from_lidar) pose.stamp_ns -= kFar_ns;
  const std::int64_t first_ns = session.odometry_from_lidar[0].stamp_ns;
  align_lidar_clock(session, ClockUse::Shared);
  EXPECT_EQ(session.findings.back().code, "clock-ambiguous");
  EXPECT_TRUE(contains(english(session.findings.back().explanation), "more than a hundred years apart"));
  EXPECT_EQ(session.odometry_from_lidar[0].stamp_ns, first_ns);
}

TEST(pose_session_reader, ambiguous_names_are_listed) {
  const TemporaryFolder folder;
  folder.write("a_hand.csv", poses(0, 0, ",", 0, 10, 0.1));
  folder.write("b_hand.csv", poses(0, 0, ",", 0, 10, 0.1));
  EXPECT_ERROR(open(folder.path()), "holds several pose files named after");
  const drive::Session single = open(folder.path() / "a_hand.csv");
  EXPECT_GE(single.world_from_ins.size(), 100u);
  EXPECT_NE(find(single, "one-stream"), nullptr);
}

TEST(pose_session_reader, real_rigs) {
  SKIP_WITHOUT(shared_data() / "ethz");
  const TemporaryFolder folder;
  for (const char* name : {"robot_arm_sim_camera.csv", "robot_arm_sim_hand.csv"})
    std::filesystem::copy_file(shared_data() / "ethz" / name, folder.path() / name);
  const drive::Session session = open(folder.path());
  EXPECT_EQ(session.odometry_from_lidar.size(), 1065u);
  EXPECT_GT(session.world_from_ins.size(), 1900u);
  EXPECT_NE(find(session, "pose-duplicate-stamps"), nullptr);
  EXPECT_ERROR(open(shared_data() / "ethz"), "holds several pose files");
}

// ---- Folders of sessions

TEST(several_sessions, are_named_so_that_they_can_be_opened) {
  const TemporaryFolder folder;
  for (const char* drive : {"day/2011_09_26_drive_0001_sync", "day/2011_09_26_drive_0002_sync"})
    write_kitti(folder, drive);
  for (const char* file : {"monday/a_hand.csv", "monday/a_lidar.csv", "tuesday/b_hand.csv", "tuesday/b_lidar.csv"})
    folder.write(std::string("logs/") + file, poses(0, 0, ",", 0, 10, 0.1));
  folder.write("logs/notes/readme.txt", "nothing\n");
  for (const char* below : {"day", "logs"}) {
    try {
      open(folder.path() / below);
      ADD_FAILURE() << below << " was opened";
    } catch (const SeveralSessions& several) {
      ASSERT_EQ(several.sessions().size(), 2U) << several.what();
      for (const auto& path : several.sessions()) {
        EXPECT_TRUE(contains(several.what(), path.string())) << several.what();
        EXPECT_NO_THROW(open(path)) << path;
      }
    }
  }
}

// ---- What no reader knows

TEST(open_session, says_what_each_reader_looks_for) {
  const TemporaryFolder folder;
  const std::string message = error_of([&] { open(folder.path()); });
  for (const auto& reader : session_readers())
    EXPECT_TRUE(contains(message, english(reader->description()))) << message;
  EXPECT_ERROR(open(folder.path() / "missing"), "missing: does not exist");
  EXPECT_ERROR(open("/dev/zero"), "/dev/zero: is a device, expected a regular file");
}

TEST(open_session, a_broken_or_empty_manifest_is_refused_with_its_place) {
  const TemporaryFolder folder;
  const std::vector<std::pair<std::string, std::string>> cases{
      {"", "session.yaml:1: is empty"},
      {"# only a comment\n", "session.yaml:1: is empty"},
      {"hello world", "session.yaml:1: is no map of keys and values; expected \"format: remount-session/1\""},
      {"\nname: x\n", "session.yaml:2: the key \"format\" is missing; expected \"format: remount-session/1\""},
      {"format: other/1\n", "session.yaml:1: format: is 'other/1', expected remount-session/1"},
      {"format: remount-session/1\nscans: [\n", "session.yaml:3: is not YAML here"},
      {std::string("\0\1\2", 3), "session.yaml:1"}};
  for (const auto& [manifest, said] : cases) {
    folder.write("s/session.yaml", manifest);
    EXPECT_ERROR(open(folder.path() / "s"), said);
    EXPECT_ERROR(open(folder.path() / "s" / "session.yaml"), said);
  }
  folder.write("log.csv", "");
  EXPECT_ERROR(open(folder.path() / "log.csv"), "log.csv: is empty (0 bytes), expected");
}

// Mutated sessions open or throw Error; nothing crashes or hangs.
TEST(open_session, mutated_sessions_never_crash) {
  const TemporaryFolder folder;
  write_kitti(folder, "k/a_sync");
  folder.write("o/ins.txt", pose_lines(20));
  folder.write("o/top_lidar-pose.txt", pose_lines(20));
  folder.write("n/a.log", inspvaxa(2183, 1.0, 90.0) + inspvaxa(2183, 1.02, 91.0) + inspvaxa(2183, 1.04, 92.0));
  folder.write("n/lidar.txt", poses(0, 0, " ", 0, 20, 0.1));
  folder.write("p/hand.csv", poses(0, 0, ",", 0, 20, 0.1));
  folder.write("p/camera.csv", poses(0, 0, ",", 0, 20, 0.1));
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder.path()))
    if (entry.is_regular_file()) files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  std::mt19937 random(5);
  for (int round = 0; round < 150; ++round) {
    const auto& file = files[random() % files.size()];
    std::ifstream stream(file, std::ios::binary);
    const std::string good(std::istreambuf_iterator<char>(stream), {});
    std::string bytes = good;
    for (unsigned i = 0; i <= random() % 6; ++i) {
      const std::size_t at = random() % (bytes.size() + 1);
      if (random() % 3 == 0)
        bytes.erase(at, random() % 40);
      else
        bytes.insert(at, 1, "0123456789-eE.,; \n\t\"#*nan"[random() % 24]);
    }
    folder.write(std::filesystem::relative(file, folder.path()), bytes);
    try {
      const drive::Session session = open(folder.path() / *std::filesystem::relative(file, folder.path()).begin());
      if (session.scans) session.scans->load(session.scans->size() - 1);
    } catch (const Error& error) {
      EXPECT_FALSE(std::string(error.what()).empty());
    }
    folder.write(std::filesystem::relative(file, folder.path()), good);
  }
}

}  // namespace
}  // namespace remount::formats
