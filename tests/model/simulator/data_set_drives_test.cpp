// Drives in the layouts of public data sets: poses, scans and mounting come back in the vehicle's axes.
#include <gtest/gtest.h>

#include <iostream>

#include "tests/model/simulator/written_drive.h"

namespace remount::simulator {
namespace {

SimulatedDrive compensated_drive() {
  SimulationOptions options = with_few_rays(2.0);
  options.motion_distortion = false;
  SimulatedDrive drive = simulate_drive(options);
  drive.session.nominal_ins_from_lidar = drive.ins_from_lidar;
  return drive;
}

/// Largest difference of the motions since the first pose, m + rad.
double motion_error(const drive::Session& read, const SimulatedDrive& drive) {
  EXPECT_EQ(read.world_from_ins.size(), drive.enu_from_ins.size());
  double worst = 0.0;
  for (std::size_t i = 0; i < std::min(read.world_from_ins.size(), drive.enu_from_ins.size()); ++i) {
    const RigidTransform found = read.world_from_ins.front().pose.inverse() * read.world_from_ins[i].pose;
    const RigidTransform exact = drive.enu_from_ins.front().pose.inverse() * drive.enu_from_ins[i].pose;
    worst = worse_of(worst, difference(found, exact).norm());
  }
  return worst;
}

TEST(data_set_drives, kitti_odometry_and_nuscenes_give_back_poses_scans_and_mounting) {
  const SimulatedDrive drive = compensated_drive();
  for (const char* format : {"kitti-odometry", "nuscenes"}) {
    const formats::TemporaryFolder folder;
    const drive::Session read = read_back(drive, format, folder);
    const double off = motion_error(read, drive);
    ASSERT_TRUE(read.nominal_ins_from_lidar) << format;
    const double mounting_off = difference(*read.nominal_ins_from_lidar, true_mounting(folder)).norm();
    std::cout << format << ": motions off by " << off << ", the mounting by " << mounting_off << " m + rad\n";
    EXPECT_LT(off, 1e-7) << format;
    EXPECT_LT(mounting_off, 1e-7) << format;
    EXPECT_EQ(read.ins_axes, drive::InsAxes::ForwardLeftUp) << format;
    EXPECT_EQ(read.scan_timing, drive::ScanTiming::Unknown) << format << ": nothing says who wrote it";
    ASSERT_EQ(read.scans->size(), drive.session.scans->size()) << format;
    for (const std::size_t scan : {std::size_t{0}, std::size_t{7}, read.scans->size() - 1}) {
      const cloud::PointCloud found = read.scans->load(scan), written = drive.session.scans->load(scan);
      EXPECT_EQ(found.points, written.points) << format;
      EXPECT_EQ(found.intensity, written.intensity) << format;
      if (format == std::string("nuscenes")) {
        EXPECT_EQ(found.ring, written.ring);
      }
      EXPECT_EQ(read.scans->stamp_ns(scan), read.world_from_ins[scan].stamp_ns) << format;
    }
  }
}

TEST(data_set_drives, scans_in_text_are_those_of_the_drive) {
  const SimulatedDrive drive = simulate_drive(with_few_rays(1.0));
  const formats::TemporaryFolder folder;
  const drive::Session read = read_back(drive, "native-text", folder);
  EXPECT_EQ(read.scan_timing, drive::ScanTiming::PerPoint);
  EXPECT_EQ(read.scans->name(0), "0000000000.csv");
  for (std::size_t scan = 0; scan < read.scans->size(); ++scan) {
    const cloud::PointCloud found = read.scans->load(scan), written = drive.session.scans->load(scan);
    ASSERT_EQ(found.points, written.points);
    ASSERT_EQ(found.ring, written.ring);
    ASSERT_EQ(found.intensity, written.intensity);
    for (std::size_t i = 0; i < found.size(); ++i)
      ASSERT_NEAR(found.time_from_stamp_s[i], written.time_from_stamp_s[i], 1e-7F);
  }
}

}  // namespace
}  // namespace remount::simulator
