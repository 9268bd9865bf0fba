#include "model/simulator/bag_drive.h"

#include <gtest/gtest.h>

#include "model/formats/files/input_file.h"
#include "model/formats/session_readers.h"
#include "tests/model/formats/temporary_folder.h"

namespace remount::simulator {
namespace {

SimulatedDrive small_drive(bool per_point_time = true) {
  SimulationOptions options;
  options.duration_s = 1.0;
  options.beams = 16;
  options.azimuth_steps = 200;
  options.per_point_time = per_point_time;
  return simulate_drive(options);
}

TEST(bag_drive, reads_back_as_it_was_simulated) {
  const SimulatedDrive drive = small_drive();
  const drive::Session& made = drive.session;
  for (const std::string format : {"rosbag1", "rosbag2", "mcap"}) {
    const formats::TemporaryFolder folder;
    Progress progress;
    write_drive(drive, folder.path() / "d", format, 2, progress);
    const drive::Session read = formats::open_session(folder.path() / "d", progress);
    EXPECT_EQ(read.format, "ros-bag");
    ASSERT_EQ(read.scans->size(), made.scans->size());
    ASSERT_EQ(read.ins.size(), made.ins.size());
    EXPECT_EQ(read.imu.size(), made.imu.size());
    EXPECT_EQ(read.gnss.size(), made.gnss.size());
    EXPECT_EQ(read.scan_timing, drive::ScanTiming::PerPoint);
    for (std::size_t i = 0; i < made.scans->size(); ++i) {
      EXPECT_EQ(read.scans->stamp_ns(i), made.scans->stamp_ns(i));
      const cloud::PointCloud written = made.scans->load(i), found = read.scans->load(i);
      EXPECT_EQ(found.points, written.points);
      EXPECT_EQ(found.ring, written.ring);
      EXPECT_EQ(found.time_from_stamp_s, written.time_from_stamp_s);
    }
    for (std::size_t i = 0; i < made.ins.size(); ++i) {
      EXPECT_EQ(read.ins[i].stamp_ns, made.ins[i].stamp_ns);
      EXPECT_NEAR(read.ins[i].latitude_rad, made.ins[i].latitude_rad, 1e-14);
      EXPECT_LT(read.ins[i].enu_from_ins.angularDistance(made.ins[i].enu_from_ins), 1e-7);
    }
    for (std::size_t i = 0; i < made.imu.size(); ++i)
      EXPECT_EQ(read.imu[i].angular_rate_radps, made.imu[i].angular_rate_radps);
  }
}

TEST(bag_drive, has_the_same_bytes_for_any_number_of_threads) {
  const SimulatedDrive drive = small_drive();
  for (const std::string format : {"rosbag1", "rosbag2", "mcap"}) {
    const formats::TemporaryFolder folder;
    Progress progress;
    const std::string name = format == "mcap" ? "drive.mcap" : format == "rosbag2" ? "drive.db3" : "drive.bag";
    for (const int threads : {1, 3})
      write_drive(drive, folder.path() / std::to_string(threads), format, threads, progress);
    EXPECT_EQ(formats::read_regular_file(folder.path() / "1" / name),
              formats::read_regular_file(folder.path() / "3" / name));
  }
}

// As many drivers leave them: nothing in the bag says how the scans are bent by motion.
TEST(bag_drive, of_points_without_times_is_read_as_one_whose_sweep_is_not_known) {
  for (const std::string format : {"rosbag1", "rosbag2", "mcap"}) {
    const formats::TemporaryFolder folder;
    Progress progress;
    write_drive(small_drive(false), folder.path() / "d", format, 1, progress);
    const drive::Session read = formats::open_session(folder.path() / "d", progress);
    EXPECT_EQ(read.scan_timing, drive::ScanTiming::Unknown) << format;
    EXPECT_TRUE(read.scans->load(0).time_from_stamp_s.empty()) << format;
  }
}

}  // namespace
}  // namespace remount::simulator
