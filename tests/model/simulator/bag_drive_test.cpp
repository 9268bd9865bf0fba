#include "model/simulator/bag_drive.h"

#include <gtest/gtest.h>

#include <cmath>
#include <iostream>

#include "algorithms/core/stamps.h"
#include "algorithms/geodesy/geodesy.h"
#include "algorithms/messages/render.h"
#include "model/drive/session_frames.h"
#include "model/formats/bags/bag_reader.h"
#include "model/formats/files/input_file.h"
#include "model/formats/session_readers.h"
#include "tests/model/formats/temporary_folder.h"
#include "tests/model/simulator/written_drive.h"
#include "tests/support/draws.h"

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

// Points, their times, poses of the INS and the nominal; stamps of messages are seconds as a double.
TEST(bag_drive, a_record_of_apollo_reads_back_as_it_was_simulated) {
  SimulatedDrive drive = small_drive();
  drive.session.nominal_ins_from_lidar = drive.ins_from_lidar;
  const drive::Session& made = drive.session;
  const formats::TemporaryFolder folder;
  Progress progress;
  write_drive(drive, folder.path() / "d", "apollo-record", 2, progress);
  const drive::Session read = bags::RecordReader().open(folder.path() / "d", progress);
  ASSERT_EQ(read.scans->size(), made.scans->size());
  ASSERT_EQ(read.world_from_ins.size(), made.ins.size());
  ASSERT_EQ(read.gnss.size(), made.gnss.size());
  double worst_point_s = 0.0, worst_pose_s = 0.0;
  for (std::size_t i = 0; i < made.scans->size(); ++i) {
    const cloud::PointCloud written = made.scans->load(i), found = read.scans->load(i);
    ASSERT_EQ(found.points, written.points);
    const double apart_s = seconds(read.scans->stamp_ns(i) - made.scans->stamp_ns(i));
    for (std::size_t k = 0; k < found.size(); ++k)
      worst_point_s = std::max(worst_point_s, std::abs(static_cast<double>(found.time_from_stamp_s[k]) + apart_s -
                                                       static_cast<double>(written.time_from_stamp_s[k])));
  }
  EXPECT_LT(worst_point_s, 1e-8);
  const geodesy::UtmGrid grid(made.ins.front().latitude_rad, made.ins.front().longitude_rad);
  const Eigen::Matrix3d flu_from_rfu = drive::forward_left_up_from(drive::InsAxes::RightForwardUp).linear();
  for (std::size_t i = 0; i < made.ins.size(); ++i) {
    const motion::InsSample& sample = made.ins[i];
    const motion::StampedPose& pose = read.world_from_ins[i];
    const geodesy::GridFix place = grid.project(sample.latitude_rad, sample.longitude_rad);
    worst_pose_s = std::max(worst_pose_s, std::abs(seconds(pose.stamp_ns - sample.stamp_ns)));
    ASSERT_EQ(pose.pose.translation(), Eigen::Vector3d(place.easting_m, place.northing_m, sample.height_m));
    ASSERT_LT((pose.pose.linear() - sample.enu_from_ins.toRotationMatrix() * flu_from_rfu).norm(), 1e-12);
  }
  EXPECT_LT(worst_pose_s, 2.5e-7);
  ASSERT_TRUE(read.nominal_ins_from_lidar);
  const RigidTransform nominal =
      drive::forward_left_up_from(drive::InsAxes::RightForwardUp) * *read.nominal_ins_from_lidar;
  EXPECT_LT((nominal.matrix() - drive.ins_from_lidar.matrix()).norm(), 1e-12);
  std::cout << "points at most " << 1e9 * worst_point_s << " ns off, poses " << 1e9 * worst_pose_s << " ns\n";
}

TEST(bag_drive, has_the_same_bytes_for_any_number_of_threads) {
  const SimulatedDrive drive = small_drive();
  for (const std::string format : {"rosbag1", "rosbag2", "mcap", "apollo-record"}) {
    const formats::TemporaryFolder folder;
    Progress progress;
    const std::string name = format == "mcap"            ? "drive.mcap"
                             : format == "rosbag2"       ? "drive.db3"
                             : format == "apollo-record" ? "drive.record.00000"
                                                         : "drive.bag";
    for (const int threads : {1, 3})
      write_drive(drive, folder.path() / std::to_string(threads), format, threads, progress);
    EXPECT_EQ(formats::read_regular_file(folder.path() / "1" / name),
              formats::read_regular_file(folder.path() / "3" / name));
  }
}

// As many drivers leave them: nothing in the bag says how the scans are bent by motion.
TEST(bag_drive, of_points_without_times_is_read_as_one_whose_sweep_is_not_known) {
  for (const std::string format : {"rosbag1", "rosbag2", "mcap", "apollo-record"}) {
    const formats::TemporaryFolder folder;
    Progress progress;
    write_drive(small_drive(false), folder.path() / "d", format, 1, progress);
    const drive::Session read = formats::open_session(folder.path() / "d", progress);
    EXPECT_EQ(read.scan_timing, drive::ScanTiming::Unknown) << format;
    EXPECT_TRUE(read.scans->load(0).time_from_stamp_s.empty()) << format;
  }
}

TEST(bag_drive, a_record_of_apollo_gives_the_mounting_within_its_sigmas) {
  SimulationOptions options = lasting(8.0);
  options.scenario = ScenarioKind::ParkingRamp;
  options.beams = 16;
  options.azimuth_steps = 200;
  const SimulatedDrive drive = simulate_drive(options);
  const RigidTransform rfu_from_flu = drive::forward_left_up_from(drive::InsAxes::RightForwardUp).inverse();
  const CalibratedDrive found =
      calibrated(drive, "apollo-record", by_pairs, RigidTransform(rfu_from_flu * options.ins_from_lidar));
  EXPECT_TRUE(calibration::is_usable(found.result)) << english(found.result.message);
  testing::expect_within_sigma(found.result, found.truth, 3.0);
}

TEST(bag_drive, packets_of_a_sensor_are_calibrated_as_those_of_a_capture) {
  ONLY_IN_LONG_TESTS();
  expect_calibrated_on_ramp(lasting(15.0), "rosbag1-velodyne");
}

TEST(bag_drive, packets_of_every_sensor_give_the_scans_of_a_capture) {
  const SimulatedDrive drive = simulate_drive(lasting(0.6));
  for (const auto& [bag_format, capture_format] : {std::pair{"rosbag1-velodyne", "velodyne"},
                                                   {"mcap-ouster", "ouster"},
                                                   {"rosbag2-hesai", "hesai"},
                                                   {"mcap-robosense", "robosense"}}) {
    const formats::TemporaryFolder bag_folder, capture_folder;
    const drive::Session bag = read_back(drive, bag_format, bag_folder);
    const drive::Session capture = read_back(drive, capture_format, capture_folder);
    EXPECT_EQ(bag.format, "ros-bag");
    EXPECT_EQ(bag.ins.size(), drive.session.ins.size()) << bag_format;
    ASSERT_TRUE(bag.scans && capture.scans) << bag_format;
    ASSERT_EQ(bag.scans->size(), capture.scans->size()) << bag_format;
    ASSERT_GT(bag.scans->size(), 4U) << bag_format;
    for (std::size_t scan = 0; scan < bag.scans->size(); ++scan) {
      EXPECT_EQ(bag.scans->stamp_ns(scan), capture.scans->stamp_ns(scan)) << bag_format;
      const cloud::PointCloud ours = bag.scans->load(scan), theirs = capture.scans->load(scan);
      EXPECT_GT(ours.size(), 1000U);
      EXPECT_EQ(ours.points, theirs.points) << bag_format;
      EXPECT_EQ(ours.time_from_stamp_s, theirs.time_from_stamp_s) << bag_format;
      EXPECT_EQ(ours.ring, theirs.ring) << bag_format;
    }
    for (const drive::Finding& finding : bag.findings)
      EXPECT_TRUE(finding.severity == drive::Severity::Note) << bag_format << ": " << english(finding.explanation);
  }
}

TEST(bag_drive, packets_have_the_same_bytes_for_any_number_of_threads) {
  const SimulatedDrive drive = small_drive();
  const formats::TemporaryFolder folder;
  Progress progress;
  for (const int threads : {1, 3})
    write_drive(drive, folder.path() / std::to_string(threads), "mcap-robosense", threads, progress);
  EXPECT_EQ(formats::read_regular_file(folder.path() / "1" / "drive.mcap"),
            formats::read_regular_file(folder.path() / "3" / "drive.mcap"));
}

}  // namespace
}  // namespace remount::simulator
