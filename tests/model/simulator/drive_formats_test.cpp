#include "model/simulator/drive_formats.h"

#include <gtest/gtest.h>

#include <iostream>
#include <set>

#include "algorithms/geodesy/geodesy.h"
#include "algorithms/geodesy/local_level.h"
#include "algorithms/messages/render.h"
#include "model/drive/session_frames.h"
#include "model/formats/poses/pose_file.h"
#include "tests/model/simulator/written_drive.h"

namespace remount::simulator {
namespace {

/// Largest distances of the LiDAR's poses as read from those of the drive, m + rad.
double pose_error(const drive::Session& session, const SimulatedDrive& drive) {
  const std::vector<motion::StampedPose> exact = exact_odometry(drive);
  EXPECT_EQ(session.odometry_from_lidar.size(), exact.size());
  double worst = 0.0;
  for (std::size_t i = 0; i < std::min(exact.size(), session.odometry_from_lidar.size()); ++i) {
    EXPECT_EQ(session.odometry_from_lidar[i].stamp_ns, exact[i].stamp_ns);
    worst = std::max(worst, difference(session.odometry_from_lidar[i].pose, exact[i].pose).norm());
  }
  return worst;
}

TEST(drive_formats, every_session_format_that_is_read_is_written) {
  std::set<std::string_view> read, written, ids;
  for (const auto& reader : formats::session_readers()) read.insert(reader->id());
  for (const DriveFormat& format : drive_format_list()) {
    written.insert(format.reader);
    EXPECT_TRUE(ids.insert(format.id).second) << format.id;
  }
  EXPECT_EQ(written, read);
  EXPECT_EQ(drive_formats().front(), "native");
}

TEST(drive_formats, every_format_is_opened_by_the_reader_that_the_list_names) {
  SimulationOptions options = with_few_rays();
  options.duration_s = 1.0;
  for (const DriveFormat& format : drive_format_list()) {
    options.clockwise = format.id != "kitti-raw";
    options.motion_distortion = !has_compensated_scans(format.id);
    const formats::TemporaryFolder folder;
    const drive::Session session = read_back(simulate_drive(options), std::string(format.id), folder);
    EXPECT_EQ(session.format, format.reader) << format.id;
    if (!session.ins.empty() || !session.world_from_ins.empty()) {
      EXPECT_EQ(session.ins_axes.value_or(format.ins_axes), format.ins_axes) << format.id;
    }
    for (const drive::Finding& finding : session.findings)
      EXPECT_NE(finding.severity, drive::Severity::Problem) << format.id << ": " << english(finding.explanation);
  }
}

TEST(drive_formats, nmea_logs_hold_positions_attitudes_and_their_errors) {
  const SimulationOptions options = in_the_south_west();  // letters, not signs
  const SimulatedDrive drive = simulate_drive(options);
  const formats::TemporaryFolder folder;
  const drive::Session session = read_back(drive, "nmea", folder);
  ASSERT_EQ(session.gnss.size(), session.ins.size());
  const SampleErrors errors = sample_errors(session.ins, drive.session.ins);
  EXPECT_LT(errors.latitude_rad, 2e-13);
  EXPECT_LT(errors.longitude_rad, 2e-13);
  EXPECT_LT(errors.height_m, 1e-4);
  EXPECT_LT(errors.turned_rad, 1e-7);
  for (const motion::InsSample& read : session.ins) {
    ASSERT_EQ(read.quality, motion::InsQuality::Good);
    ASSERT_NEAR(read.sigma.position_enu_m.x(), options.ins_position_noise_m, 1e-6);
    ASSERT_NEAR(read.sigma.attitude_rad.z(), degrees_to_radians(options.ins_attitude_noise_deg), 1e-7);
  }
  EXPECT_LT(pose_error(session, drive), 1e-9);
}

TEST(drive_formats, nmea_logs_run_over_midnight_and_say_when_corrections_are_lost) {
  SimulationOptions options = with_few_rays();
  options.ins_trouble.degraded_start_s = 1.0;
  options.ins_trouble.degraded_s = 1.0;
  SimulatedDrive drive = simulate_drive(options);
  constexpr std::int64_t kDay_ns = 86'400'000'000'000;
  const std::int64_t shift_ns = kDay_ns - drive.session.ins[50].stamp_ns % kDay_ns;
  for (motion::InsSample& sample : drive.session.ins) sample.stamp_ns += shift_ns;
  const formats::TemporaryFolder folder;
  const drive::Session session = read_back(drive, "nmea", folder);
  ASSERT_EQ(session.ins.size(), drive.session.ins.size());
  std::size_t degraded = 0;
  for (std::size_t i = 0; i < session.ins.size(); ++i) {
    ASSERT_EQ(session.ins[i].stamp_ns, drive.session.ins[i].stamp_ns);
    ASSERT_EQ(session.ins[i].quality, drive.session.ins[i].quality);
    degraded += session.ins[i].quality == motion::InsQuality::Degraded;
  }
  EXPECT_GT(degraded, 50u);
}

TEST(drive_formats, nmea_drives_give_the_mounting_that_stands_beside_them) {
  SimulationOptions options = parking_ramp();
  options.ins_rate_hz = 10.0;  // each sample is a fix as well
  const auto [result, truth, error] = calibrated(simulate_drive(options), "nmea", by_trajectories);
  EXPECT_TRUE(calibration::is_usable(result)) << english(result.message);
  EXPECT_LT(error.rotation_deg, 0.05);
  EXPECT_LT(std::hypot(error.x_m, error.y_m), 0.02);
}

// A fix with every sample of the INS, a short drive and a free antenna: much is hardly shown, and steps along that stay
// long. That is a result with wide sigmas, not a failure.
TEST(drive_formats, nmea_drives_that_show_little_are_solved_all_the_same) {
  SimulationOptions options = with_few_rays();
  options.scenario = ScenarioKind::Hill;
  options.duration_s = 4.0;
  for (unsigned seed = 1; seed <= 2; ++seed) {
    options.seed = seed;
    const auto [result, truth, error] = calibrated(simulate_drive(options), "nmea", by_trajectories);
    EXPECT_TRUE(result.status == calibration::Status::Ok || result.status == calibration::Status::Degenerate)
        << english(result.message);
    ASSERT_TRUE(result.estimate(calibration::Parameter::Pitch).sigma) << "pitch is told";
    EXPECT_LT(*result.estimate(calibration::Parameter::Pitch).sigma, degrees_to_radians(2.0)) << "it says something";
    testing::expect_within_sigma(result, truth, 3.5);
  }
}

TEST(drive_formats, gpx_tracks_hold_the_fixes_of_the_antenna) {
  const SimulatedDrive drive = simulate_drive(with_few_rays());
  const formats::TemporaryFolder folder;
  const drive::Session session = read_back(drive, "gpx", folder);
  ASSERT_EQ(session.gnss.size(), drive.session.gnss.size());
  EXPECT_TRUE(session.ins.empty());
  for (std::size_t i = 0; i < session.gnss.size(); ++i) {
    ASSERT_EQ(session.gnss[i].stamp_ns, drive.session.gnss[i].stamp_ns);
    ASSERT_NEAR(session.gnss[i].latitude_rad, drive.session.gnss[i].latitude_rad, 1e-15);
    ASSERT_NEAR(session.gnss[i].longitude_rad, drive.session.gnss[i].longitude_rad, 1e-15);
    ASSERT_NEAR(session.gnss[i].height_m, drive.session.gnss[i].height_m, 1e-9);
  }
  EXPECT_LT(pose_error(session, drive), 1e-9);
  const formats::DocumentNode truth = truth_in(folder);
  ASSERT_NE(truth.find("antenna_in_lidar_m"), nullptr);
  SimulationOptions without = with_few_rays();
  without.gnss.rate_hz = 0.0;
  Progress progress;
  EXPECT_ERROR(write_drive(simulate_drive(without), folder.path() / "a", "gpx", 1, progress), "gnss_rate_hz");
}

TEST(drive_formats, apollo_odometry_is_on_the_grid_with_attitudes_of_true_north) {
  const SimulatedDrive drive = simulate_drive(with_few_rays());
  const formats::TemporaryFolder folder;
  const drive::Session session = read_back(drive, "apollo-csv", folder);
  ASSERT_EQ(session.world_from_ins.size(), drive.session.ins.size());
  // As the file has them: the session's were turned to the grid (tests/model/conventions/pose_north_test.cpp).
  std::vector<drive::Finding> none;
  const std::vector<motion::StampedPose> logged =
      formats::read_pose_file(drive_in(folder) / "ins.csv", formats::PoseFormat::ApolloCsv, none);
  ASSERT_EQ(logged.size(), drive.session.ins.size());
  EXPECT_EQ(session.ins_axes, drive::InsAxes::RightForwardUp);
  const geodesy::UtmGrid grid(drive.session.ins.front().latitude_rad, drive.session.ins.front().longitude_rad);
  const Eigen::Matrix3d flu_from_rfu = drive::forward_left_up_from(drive::InsAxes::RightForwardUp).linear();
  for (std::size_t i = 0; i < session.world_from_ins.size(); ++i) {
    const motion::InsSample& written = drive.session.ins[i];
    const motion::StampedPose& read = logged[i];
    ASSERT_EQ(read.stamp_ns, written.stamp_ns);
    const geodesy::GridFix place = grid.project(written.latitude_rad, written.longitude_rad);
    ASSERT_LT((read.pose.translation() - Eigen::Vector3d(place.easting_m, place.northing_m, written.height_m)).norm(),
              1e-6);
    ASSERT_LT((read.pose.linear() - written.enu_from_ins.toRotationMatrix() * flu_from_rfu).norm(), 1e-9);
  }
  EXPECT_LT(pose_error(session, drive), 1e-9);
}

TEST(drive_formats, apollo_drives_in_the_middle_of_a_zone_give_the_mounting_in_their_own_axes) {
  SimulationOptions options = parking_ramp();
  options.longitude_deg = 9.0;  // grid north is true north
  const auto [result, truth, error] = calibrated(simulate_drive(options), "apollo-csv", by_trajectories);
  EXPECT_LT(error.rotation_deg, 0.05) << english(result.message);
  EXPECT_LT(std::hypot(error.x_m, error.y_m), 0.02);
}

TEST(drive_formats, scans_in_las_are_those_of_the_drive_but_for_their_rings) {
  SimulationOptions options = with_few_rays();
  options.duration_s = 1.0;
  const SimulatedDrive drive = simulate_drive(options);
  const formats::TemporaryFolder folder;
  const drive::Session session = read_back(drive, "native-las", folder);
  ASSERT_EQ(session.scans->size(), drive.session.scans->size());
  EXPECT_EQ(session.scan_timing, drive::ScanTiming::PerPoint);
  EXPECT_NE(session.scans->name(0).find(".las"), std::string::npos) << session.scans->name(0);
  for (std::size_t scan = 0; scan < session.scans->size(); ++scan) {
    const cloud::PointCloud read = session.scans->load(scan), written = drive.session.scans->load(scan);
    ASSERT_EQ(session.scans->stamp_ns(scan), drive.session.scans->stamp_ns(scan));
    ASSERT_EQ(read.size(), written.size());
    ASSERT_EQ(read.time_from_stamp_s.size(), written.size());
    for (std::size_t i = 0; i < read.size(); ++i) {
      ASSERT_LT((read.points[i] - written.points[i]).cwiseAbs().maxCoeff(), 6e-5f);
      ASSERT_NEAR(read.time_from_stamp_s[i], written.time_from_stamp_s[i], 1e-6);
      ASSERT_NEAR(read.intensity[i], 65535.0f * written.intensity[i], 1.0f);
    }
  }
}

}  // namespace
}  // namespace remount::simulator
