#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iostream>

#include "algorithms/core/error.h"
#include "algorithms/messages/render.h"
#include "model/drive/session_frames.h"
#include "model/formats/poses/pose_file.h"
#include "model/formats/session_readers.h"
#include "model/method_registry/calibration_method.h"
#include "model/pipeline/pipeline.h"
#include "tests/model/formats/temporary_folder.h"
#include "tests/support/calibration_checks.h"
#include "tests/support/findings.h"
#include "tests/support/forwarded_scans.h"
#include "tests/support/kept_scans.h"
#include "tests/support/tunnel_drive.h"

namespace remount::methods {
namespace {

// The long test does the same over nine kilometres.
TEST(fusion_run, goes_through_a_tunnel_where_scans_alone_slip) {
  constexpr double kLength_m = 300.0;
  simulator::SimulationOptions options = testing::tunnel_options(kLength_m);
  // Scans alone keep the speed with which they lost sight of it; in some drives that happens to be the mean.
  options.seed = 4;
  const simulator::SimulatedDrive drive = testing::simulate_drive(options);
  const settings::Settings settings = testing::settings_of(drive);
  Progress progress;
  const FusionRun fused = run_fusion_odometry(drive.session, drive.ins_from_lidar, settings, 0, progress);
  const FusionRun alone =
      run_fusion_odometry(drive.session, drive.ins_from_lidar, testing::scans_alone(settings), 0, progress);
  const double fused_m = testing::end_error_m(drive, fused), alone_m = testing::end_error_m(drive, alone);
  std::cout << "    end off by " << fused_m << " m, scans alone " << alone_m << " m\n";
  EXPECT_LT(fused_m, 0.005 * kLength_m);
  EXPECT_GT(alone_m, 4.0 * 0.005 * kLength_m);
  EXPECT_TRUE(testing::has_code(fused.findings, "odometry-by-wheels"));
  EXPECT_TRUE(testing::has_code(alone.findings, "odometry-guessed"));
}

struct Error10 {
  double shift_m, turn_deg;
};

// Ten scans of KITTI by the LiDAR alone (it has no wheels), against the INS through KITTI's own calibration.
Error10 kitti_error(const std::string& sequence) {
  const std::filesystem::path data = std::filesystem::path(REMOUNT_SOURCE_DIR) / ".." / "shared" / "data" / "kitti";
  Progress progress;
  const drive::Session session = formats::open_session(data / sequence, progress);
  RigidTransform ins_from_lidar;
  std::ifstream truth(data / "truth_ins_from_lidar.txt");
  for (int row = 0; row < 4; ++row)
    for (int column = 0; column < 4; ++column) truth >> ins_from_lidar.matrix()(row, column);
  const FusionRun run = run_fusion_odometry(session, std::nullopt, {}, 0, progress);
  const motion::MotionTrack track(drive::metric_poses(session));
  const auto lidar_at = [&](std::size_t scan) {
    return RigidTransform(*track.at(session.scans->stamp_ns(scan)) * ins_from_lidar);
  };
  const std::size_t last = session.scans->size() - 1;
  const RigidTransform expected = lidar_at(0).inverse() * lidar_at(last);
  const RigidTransform found = run.odometry_from_lidar.front().pose.inverse() * run.odometry_from_lidar.back().pose;
  const RigidTransform error = expected.inverse() * found;
  const Error10 result{error.translation().norm(), radians_to_degrees(so3_log(error.linear()).norm())};
  std::cout << "    " << sequence << ": " << last + 1 << " scans over " << expected.translation().norm()
            << " m, off by " << result.shift_m << " m, " << result.turn_deg << " deg\n";
  return result;
}

TEST(fusion_run, ten_scans_of_kitti_agree_with_the_ins) {
  if (!std::filesystem::exists(std::filesystem::path(REMOUNT_SOURCE_DIR) / ".." / "shared" / "data" / "kitti"))
    GTEST_SKIP() << "no recorded data beside the checkout";
  for (const char* sequence : {"05", "07"}) {
    const Error10 error = kitti_error(sequence);
    EXPECT_LT(error.shift_m, 0.05) << sequence;
    EXPECT_LT(error.turn_deg, 0.15) << sequence;
  }
}

pipeline::PipelineInput street_input(double duration_s) {
  simulator::SimulationOptions options;
  options.duration_s = duration_s;
  options.beams = 32;
  options.azimuth_steps = 600;
  const simulator::SimulatedDrive drive = testing::simulate_drive(options);
  pipeline::PipelineInput input;
  input.sessions.push_back(std::make_shared<drive::Session>(drive.session));
  input.nominal_ins_from_lidar = drive.ins_from_lidar;
  input.settings = testing::settings_of(drive);
  return input;
}

TEST(fusion_method, calibrates_from_its_poses_and_tells_of_them) {
  const pipeline::PipelineInput input = street_input(12.0);
  Progress progress;
  const pipeline::PipelineOutput output = method_registry::calibration_method("fusion-odometry").run(input, progress);
  EXPECT_EQ(output.method, "fusion-odometry");
  ASSERT_TRUE(output.result.status == calibration::Status::Ok ||
              output.result.status == calibration::Status::Degenerate)
      << english(output.result.message);
  const testing::CalibrationError error = testing::error_of(output.result, *input.nominal_ins_from_lidar);
  EXPECT_LT(error.rotation_deg, 0.3);
  EXPECT_LT(std::hypot(error.x_m, error.y_m), 0.15);
  ASSERT_EQ(output.plots.size(), 4u);
  EXPECT_TRUE(output.plots[0].equal_axes);
  EXPECT_EQ(output.plots[0].curves[0].z.size(), output.plots[0].curves[0].x.size());
  EXPECT_EQ(output.plots[1].curves[0].sigma.size(), output.plots[1].curves[0].y.size());
  ASSERT_EQ(output.quantities.size(), 1u);
  EXPECT_NEAR(output.quantities[0].value, 12.0 * 6.0, 2.0);
}

// Wheels and gyroscope reach the LiDAR through the nominal: poses that rest on them would confirm it.
TEST(fusion_method, a_wrong_nominal_is_not_confirmed) {
  pipeline::PipelineInput input = street_input(12.0);
  const RigidTransform truth = *input.nominal_ins_from_lidar;
  input.nominal_ins_from_lidar =
      truth * make_rigid(rotation_from_yaw_pitch_roll({degrees_to_radians(2.0), 0.0, 0.0}), Eigen::Vector3d::Zero());
  Progress progress;
  const pipeline::PipelineOutput output = method_registry::calibration_method("fusion-odometry").run(input, progress);
  ASSERT_TRUE(output.result.status == calibration::Status::Ok ||
              output.result.status == calibration::Status::Degenerate)
      << english(output.result.message);
  EXPECT_LT(testing::error_of(output.result, truth).rotation_deg, 0.3);
  testing::expect_within_sigma(output.result, truth, 3.5);
}

TEST(fusion_method, no_pair_rests_on_scans_that_do_not_tell_the_motion) {
  const simulator::SimulatedDrive drive = testing::simulate_drive(testing::tunnel_options(200.0));
  pipeline::PipelineInput input;
  auto session = std::make_shared<drive::Session>(drive.session);
  session->wheels.clear();  // nothing carries the odometry on
  session->imu.clear();
  session->barometer.clear();
  input.sessions.push_back(session);
  input.nominal_ins_from_lidar = drive.ins_from_lidar;
  Progress progress;
  const pipeline::PipelineOutput output = method_registry::calibration_method("fusion-odometry").run(input, progress);
  EXPECT_TRUE(testing::has_code(output.findings, "odometry-breaks"));
  EXPECT_FALSE(output.result.status == calibration::Status::Ok);
}

/// The scans of a session, of which one has times that make no sense.
class BadTimes : public testing::ForwardedScans {
 public:
  BadTimes(std::shared_ptr<const ScanSource> scans, float time_s) : ForwardedScans(std::move(scans)), time_s_(time_s) {}
  cloud::PointCloud load(std::size_t scan) const override {
    cloud::PointCloud cloud = ForwardedScans::load(scan);
    if (scan == 3 && !cloud.time_from_stamp_s.empty()) cloud.time_from_stamp_s[5] = time_s_;
    return cloud;
  }

 private:
  float time_s_;
};

TEST(fusion_run, a_scan_with_senseless_point_times_does_not_end_the_odometry) {
  const pipeline::PipelineInput input = street_input(1.0);
  for (const float time_s : {std::numeric_limits<float>::infinity(), std::numeric_limits<float>::quiet_NaN(), 50.0f}) {
    drive::Session session = *input.sessions[0];
    session.scans = std::make_shared<BadTimes>(session.scans, time_s);
    Progress progress;
    const FusionRun run = run_fusion_odometry(session, input.nominal_ins_from_lidar, input.settings, 0, progress);
    EXPECT_EQ(run.odometry.scans.size(), session.scans->size());
    EXPECT_TRUE(testing::has_code(run.findings, "odometry-point-times")) << time_s;
  }
}

TEST(fusion_run, tells_of_streams_that_never_took_part_and_of_a_mounting_that_is_not_set) {
  const pipeline::PipelineInput input = street_input(1.0);
  drive::Session session = *input.sessions[0];
  Progress progress;
  FusionRun run = run_fusion_odometry(session, input.nominal_ins_from_lidar, input.settings, 0, progress);
  EXPECT_FALSE(testing::has_code(run.findings, "odometry-unused"));
  EXPECT_FALSE(testing::has_code(run.findings, "odometry-mounting-unset"));
  for (motion::BarometerSample& sample : session.barometer) sample.stamp_ns += 3600000000000;  // another clock
  run = run_fusion_odometry(session, input.nominal_ins_from_lidar, {}, 0, progress);
  EXPECT_TRUE(testing::has_code(run.findings, "odometry-unused"));
  EXPECT_TRUE(testing::has_code(run.findings, "odometry-mounting-unset"));
}

TEST(fusion_method, without_an_ins_it_says_so_and_keeps_its_plots) {
  pipeline::PipelineInput input = street_input(1.0);
  auto session = std::make_shared<drive::Session>(*input.sessions[0]);
  session->ins.clear();
  input.sessions = {session};
  Progress progress;
  const pipeline::PipelineOutput output = method_registry::calibration_method("fusion-odometry").run(input, progress);
  EXPECT_EQ(output.result.status, calibration::Status::NoUsableData);
  EXPECT_NE(english(output.result.message).find("no session has an INS"), std::string::npos);
  EXPECT_EQ(output.plots.size(), 4u);
  EXPECT_TRUE(testing::has_code(output.findings, "odometry-without-ins"));
}

TEST(fusion_method, refuses_a_session_without_scans_and_can_be_cancelled) {
  pipeline::PipelineInput input = street_input(1.0);
  std::stop_source stop;
  stop.request_stop();
  Progress cancelled(stop.get_token());
  EXPECT_EQ(method_registry::calibration_method("fusion-odometry").run(input, cancelled).result.status,
            calibration::Status::Cancelled);
  auto session = std::make_shared<drive::Session>(*input.sessions[0]);
  session->scans = nullptr;
  input.sessions = {session};
  Progress progress;
  EXPECT_THROW(method_registry::calibration_method("fusion-odometry").run(input, progress), Error);
}

TEST(fusion_run, poses_are_written_as_pose_files_are_read) {
  std::vector<motion::StampedPose> poses;
  for (int i = 0; i < 5; ++i)
    poses.push_back(
        {1700000000123456789 + 100000001LL * i, make_rigid(so3_exp({0.1 * i, -0.2, 0.5 * i}), {1.5 * i, -2.0, 0.25})});
  const formats::TemporaryFolder folder;
  const std::filesystem::path file = folder.write("poses.txt", odometry_text(poses));
  std::vector<drive::Finding> findings;
  ASSERT_EQ(formats::recognise_pose_file(file), formats::PoseFormat::Tum);
  const std::vector<motion::StampedPose> read = formats::read_pose_file(file, formats::PoseFormat::Tum, findings);
  ASSERT_EQ(read.size(), poses.size());
  for (std::size_t i = 0; i < read.size(); ++i) {
    EXPECT_EQ(read[i].stamp_ns, poses[i].stamp_ns);
    EXPECT_LT(difference(read[i].pose, poses[i].pose).norm(), 1e-8);
  }
}

}  // namespace
}  // namespace remount::methods
