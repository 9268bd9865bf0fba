#include "model/simulator/peer_formats.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <iostream>

#include "algorithms/geodesy/local_level.h"
#include "algorithms/messages/render.h"
#include "model/drive/session_frames.h"
#include "model/method_registry/calibration_method.h"
#include "model/pipeline/pipeline.h"
#include "model/simulator/scene.h"
#include "tests/model/simulator/written_drive.h"

namespace remount::simulator {
namespace {

SimulationOptions small_peer_options() {
  SimulationOptions options = with_few_rays();
  options.ins_position_noise_m = options.ins_attitude_noise_deg = 0.0;
  return options;
}

/// Largest error of P X = X Q over steps of a second, with motions as read and the truth as written.
/// The stamps are the drive's own: readers may move the LiDAR's to where they think the INS's clock is.
double largest_contradiction(const drive::Session& session, const SimulatedDrive& drive,
                             const RigidTransform& ins_from_lidar) {
  const std::vector<motion::StampedPose> ins = drive::metric_poses(session);
  const std::vector<motion::StampedPose>& lidar = session.odometry_from_lidar;
  const auto ins_at = [&](std::int64_t stamp_ns) {
    for (const motion::StampedPose& pose : ins)
      if (std::abs(pose.stamp_ns - stamp_ns) < 1000) return pose.pose;
    ADD_FAILURE() << "no INS pose at " << stamp_ns;
    return RigidTransform::Identity();
  };
  double largest = 0.0;
  for (std::size_t i = 0; i + 10 < lidar.size(); i += 3) {
    const RigidTransform p =
        ins_at(drive.enu_from_ins[i + 10].stamp_ns).inverse() * ins_at(drive.enu_from_ins[i].stamp_ns);
    const RigidTransform q = lidar[i + 10].pose.inverse() * lidar[i].pose;
    largest = std::max(largest, ((p * ins_from_lidar).matrix() - (ins_from_lidar * q).matrix()).norm());
  }
  return largest;
}

TEST(peer_formats, poses_and_novatel_logs_fit_the_truth_that_stands_beside_them) {
  const SimulatedDrive drive = simulate_drive(small_peer_options());
  for (const char* format : {"poses", "novatel-inspvax"}) {
    const formats::TemporaryFolder folder;
    const drive::Session session = read_back(drive, format, folder);
    ASSERT_EQ(session.odometry_from_lidar.size(), 30u);
    const double off = largest_contradiction(session, drive, true_mounting(folder));
    EXPECT_LT(off, 1e-4) << format << ": the local level turns by less within 20 m";
  }
}

TEST(peer_formats, novatel_logs_hold_the_samples_of_the_drive) {
  const SimulatedDrive drive = simulate_drive(small_peer_options());
  const formats::TemporaryFolder folder;
  const drive::Session session = read_back(drive, "novatel-inspvax", folder);
  ASSERT_EQ(session.ins.size(), drive.session.ins.size());
  EXPECT_EQ(session.ins_axes, drive::InsAxes::RightForwardUp);
  const Eigen::Quaterniond flu_from_rfu(drive::forward_left_up_from(drive::InsAxes::RightForwardUp).linear());
  for (std::size_t i = 0; i < session.ins.size(); ++i) {
    const motion::InsSample &read = session.ins[i], &written = drive.session.ins[i];
    ASSERT_EQ(read.stamp_ns, written.stamp_ns);
    ASSERT_NEAR(read.latitude_rad, written.latitude_rad, 1e-14);
    ASSERT_NEAR(read.height_m, written.height_m, 1e-9);
    ASSERT_LT(read.enu_from_ins.angularDistance(written.enu_from_ins * flu_from_rfu), 1e-7);
    ASSERT_EQ(read.quality, motion::InsQuality::Good);
  }
}

TEST(peer_formats, opencalib_folders_hold_scans_and_poses) {
  const SimulatedDrive drive = simulate_drive(small_peer_options());
  const formats::TemporaryFolder folder;
  const drive::Session session = read_back(drive, "opencalib", folder);
  ASSERT_EQ(session.scans->size(), 30u);
  EXPECT_EQ(session.scan_timing, drive::ScanTiming::PerPoint);
  EXPECT_EQ(session.scans->stamp_ns(7), drive.session.scans->stamp_ns(7));
  EXPECT_EQ(session.scans->load(7).points, drive.session.scans->load(7).points);
  const std::vector<motion::StampedPose> written = drive::metric_poses(drive.session);
  ASSERT_EQ(session.world_from_ins.size(), written.size());
  for (std::size_t i = 0; i < written.size(); i += 10) {
    ASSERT_EQ(session.world_from_ins[i].stamp_ns, written[i].stamp_ns);
    ASSERT_LT((session.world_from_ins[i].pose.matrix() - written[i].pose.matrix()).norm(), 1e-9);
  }
}

TEST(peer_formats, smartloc_files_hold_speed_and_turn_rates_of_the_vehicle_and_the_true_antenna) {
  SimulationOptions options = small_peer_options();
  options.wheels.noise_mps = options.wheels.slip = options.imu.gyro_noise_dps = options.imu.gyro_bias_dps = 0.0;
  const SimulatedDrive drive = simulate_drive(options);
  const formats::TemporaryFolder folder;
  const drive::Session session = read_back(drive, "smartloc", folder);
  ASSERT_EQ(session.wheels.size(), drive.session.wheels.size());
  ASSERT_EQ(session.gnss.size(), session.wheels.size());
  const Eigen::Matrix3d vehicle_from_imu = (drive.sensors.vehicle_from_ins * drive.sensors.ins_from_imu).linear();
  const geodesy::LocalLevel level(degrees_to_radians(options.latitude_deg), degrees_to_radians(options.longitude_deg),
                                  options.height_m);
  const Scene scene(options);
  for (std::size_t i = 0; i < session.wheels.size(); ++i) {
    const motion::WheelSample& written = drive.session.wheels[i];
    ASSERT_EQ(session.wheels[i].stamp_ns, written.stamp_ns - drive.session.wheels.front().stamp_ns);
    ASSERT_NEAR(session.wheels[i].rear_left_mps, 0.5 * (written.rear_left_mps + written.rear_right_mps), 1e-12);
    // The IMU samples at these very times.
    const motion::ImuSample& imu = drive.session.imu[2 * i];
    ASSERT_EQ(imu.stamp_ns, written.stamp_ns);
    ASSERT_LT((session.imu[i].angular_rate_radps - vehicle_from_imu * imu.angular_rate_radps).norm(), 1e-12);
    const double time_s = static_cast<double>(written.stamp_ns - kDriveStart_ns) * 1e-9;
    const Eigen::Vector3d antenna = scene.enu_from_ins(time_s) * drive.sensors.antenna_in_ins_m;
    ASSERT_LT((level.position_enu_m(session.gnss[i]) - antenna).norm(), 1e-6);
  }
}

TEST(peer_formats, smartloc_drives_show_where_the_antenna_is) {
  SimulationOptions options = small_peer_options();
  options.scenario = ScenarioKind::FigureEight;
  options.duration_s = 90.0;
  const SimulatedDrive drive = simulate_drive(options);
  const formats::TemporaryFolder folder;
  pipeline::PipelineInput input;
  input.sessions = {std::make_shared<drive::Session>(read_back(drive, "smartloc", folder))};
  Progress progress;
  const calibration::CalibrationResult result =
      method_registry::calibration_method("vehicle-frame").run(input, progress).result;
  const Eigen::Vector3d truth = drive.sensors.vehicle_from_ins * drive.sensors.antenna_in_ins_m;
  const Eigen::Vector3d off = result.mounting.reference_from_sensor.translation() - truth;
  std::cout << "    antenna off by " << off.x() << ", " << off.y() << " m; " << english(result.message) << "\n";
  for (const std::size_t i : {0u, 1u}) {
    ASSERT_TRUE(result.known[calibration::kParameters[i]].observed) << english(result.message);
    EXPECT_LT(std::abs(off[static_cast<Eigen::Index>(i)]),
              std::max(0.02, 3.5 * result.estimate(calibration::kParameters[i]).sigma.value()))
        << i;
  }
}

TEST(peer_formats, smartloc_refuses_a_machine_without_wheels) {
  const formats::TemporaryFolder folder;
  Progress progress;
  SimulationOptions options = small_peer_options();
  options.wheels.rate_hz = 0.0;
  EXPECT_ERROR(write_drive(simulate_drive(options), folder.path() / "a", "smartloc", 1, progress), "wheels and IMU");
}

TEST(peer_formats, opencalib_refuses_what_it_cannot_say) {
  const formats::TemporaryFolder folder;
  Progress progress;
  SimulationOptions options = small_peer_options();
  options.scan_rate_hz = 7.0;
  EXPECT_ERROR(write_drive(simulate_drive(options), folder.path() / "b", "opencalib", 1, progress), "milliseconds");
  EXPECT_ERROR(write_drive(simulate_drive(options), folder.path() / "c", "bag", 1, progress), "is not a format");
}

}  // namespace
}  // namespace remount::simulator
