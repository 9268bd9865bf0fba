// Trajectory alignment of whole drives: simulated, with known truth, and recorded.
#include "model/methods/trajectory/trajectory_method.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>

#include "algorithms/core/error.h"
#include "algorithms/messages/render.h"
#include "messages/methods.h"
#include "model/formats/session_readers.h"
#include "model/method_registry/calibration_method.h"
#include "model/pipeline/pipeline.h"
#include "model/simulator/simulator.h"
#include "tests/support/calibration_checks.h"
#include "tests/support/kept_scans.h"
#include "tests/support/recorded_drives.h"

namespace remount::methods {

using drive::Session;
using simulator::SimulatedDrive;

namespace {

simulator::SimulationOptions street(double duration_s) {
  simulator::SimulationOptions options;
  options.duration_s = duration_s;
  options.beams = 16;
  options.azimuth_steps = 600;
  options.ins_position_noise_m = 0.02;
  options.ins_attitude_noise_deg = 0.05;
  return options;
}

pipeline::PipelineOutput run(const std::vector<Session>& sessions, const settings::Settings& settings = {}) {
  pipeline::PipelineInput input;
  for (const Session& session : sessions) input.sessions.push_back(std::make_shared<Session>(session));
  input.settings = settings;
  Progress progress;
  return method_registry::calibration_method("trajectory").run(input, progress);
}

/// The drive with the LiDAR's true motion as poses of an odometry whose distances are wrong by a share.
Session with_poses(const SimulatedDrive& drive, double scale) {
  Session session = drive.session;
  session.scans.reset();
  RigidTransform odometry = RigidTransform::Identity();
  for (std::size_t i = 0; i < drive.enu_from_ins.size(); ++i) {
    if (i > 0) {
      RigidTransform step = (drive.enu_from_ins[i - 1].pose * drive.ins_from_lidar).inverse() *
                            drive.enu_from_ins[i].pose * drive.ins_from_lidar;
      step.translation() *= 1.0 + scale;
      odometry = odometry * step;
    }
    session.odometry_from_lidar.push_back({drive.session.scans->stamp_ns(i), odometry});
  }
  return session;
}

SimulatedDrive drive_with_fixes(double duration_s, double outlier_share) {
  simulator::SimulationOptions options = street(duration_s);
  options.gnss.rate_hz = 5.0;
  options.gnss.noise_m = 0.02;
  options.gnss.vertical_noise_m = 0.03;
  options.gnss.outlier_share = outlier_share;
  return testing::simulate_drive(options);
}

pipeline::PipelineOutput run_by_fixes(const SimulatedDrive& drive, double scale) {
  Session session = with_poses(drive, scale);
  session.ins.clear();
  return run({session});
}

RigidTransform antenna_from_lidar(const SimulatedDrive& drive) {
  return make_rigid(Eigen::Matrix3d::Identity(), -(drive.ins_from_lidar.inverse() * drive.sensors.antenna_in_ins_m));
}

void expect_plots(const pipeline::PipelineOutput& output, std::size_t maps) {
  ASSERT_GE(output.plots.size(), 1 + maps);
  for (const calibration::Plot& plot : output.plots)
    for (const calibration::Curve& curve : plot.curves) {
      EXPECT_EQ(curve.x.size(), curve.y.size()) << plot.title;
      EXPECT_GT(curve.x.size(), 10u) << plot.title << ": " << curve.name;
    }
  EXPECT_TRUE(output.plots.back().equal_axes);
  for (const calibration::Curve& curve : output.plots.back().curves)
    EXPECT_EQ(curve.z.size(), curve.x.size()) << curve.name << ": a map is shown in space as well";
}

TEST(trajectory_method, a_simulated_street_is_solved_from_its_scans_within_sigma) {
  const SimulatedDrive drive = testing::simulate_drive(street(24.0));
  const pipeline::PipelineOutput output = run({drive.session});
  EXPECT_EQ(output.method, "trajectory");
  EXPECT_TRUE(output.result.status == calibration::Status::Ok ||
              output.result.status == calibration::Status::Degenerate)
      << english(output.result.message);
  EXPECT_EQ(output.result.mounting.reference, calibration::BodyFrame::Ins);
  const testing::CalibrationError error = testing::error_of(output.result, drive.ins_from_lidar);
  for (const std::size_t i : {0, 1, 3, 4, 5})
    EXPECT_TRUE(output.result.known[calibration::kParameters[i]].observed) << to_string(calibration::kParameters[i]);
  EXPECT_LT(error.rotation_deg, 0.1);
  EXPECT_LT(std::hypot(error.x_m, error.y_m), 0.1);
  testing::expect_within_sigma(output.result, drive.ins_from_lidar, 3.5);
  expect_plots(output, 1);
}

TEST(trajectory_method, positions_alone_give_the_lever_arm_of_the_antenna) {
  const SimulatedDrive drive = drive_with_fixes(90.0, 0.0);
  const pipeline::PipelineOutput output = run_by_fixes(drive, 0.0);
  EXPECT_EQ(output.result.mounting.reference, calibration::BodyFrame::Antenna);
  EXPECT_EQ(output.result.status, calibration::Status::Degenerate);
  EXPECT_NE(english(output.result.message).find("lever arm"), std::string::npos) << english(output.result.message);
  testing::error_of(output.result, antenna_from_lidar(drive));
  EXPECT_TRUE(output.result.known[calibration::Parameter::X].observed &&
              output.result.known[calibration::Parameter::Y].observed);
  EXPECT_FALSE(output.result.known[calibration::Parameter::Yaw].observed ||
               output.result.known[calibration::Parameter::Pitch].observed ||
               output.result.known[calibration::Parameter::Roll].observed);
  testing::expect_within_sigma(output.result, antenna_from_lidar(drive), 3.5);
  expect_plots(output, 1);
}

TEST(trajectory_method, one_percent_of_drift_and_a_fifth_of_wrong_fixes_are_survived) {
  const SimulatedDrive drive = drive_with_fixes(120.0, 0.2);
  const pipeline::PipelineOutput output = run_by_fixes(drive, 0.01);
  testing::error_of(output.result, antenna_from_lidar(drive));
  ASSERT_TRUE(output.result.known[calibration::Parameter::X].observed &&
              output.result.known[calibration::Parameter::Y].observed)
      << english(output.result.message);
  testing::expect_within_sigma(output.result, antenna_from_lidar(drive), 3.5);
  bool told = false;
  for (const drive::Finding& finding : output.findings) told = told || finding.code == "trajectory-outliers";
  EXPECT_TRUE(told);
}

/// Without that x was off by six sigma, and with a setting of no by twenty.
TEST(trajectory_method, positions_alone_leave_the_clocks_an_unknown_of_x) {
  for (const calibration::ClockOffsetUse use : {calibration::ClockOffsetUse::Auto, calibration::ClockOffsetUse::No}) {
    simulator::SimulationOptions options = street(60.0);
    options.scenario = simulator::ScenarioKind::FigureEight;
    options.gnss.rate_hz = 5.0;
    options.gnss.noise_m = 0.02;
    options.speed_swing = 0.15;
    options.lidar_clock_offset_s = 0.1;
    options.seed = 51;
    const SimulatedDrive drive = testing::simulate_drive(options);
    Session session = with_poses(drive, 0.0);
    session.ins.clear();
    settings::Settings settings;
    settings.solve.apply_time_offset = use;
    const pipeline::PipelineOutput output = run({session}, settings);
    testing::error_of(output.result, antenna_from_lidar(drive));
    std::printf("  offset %.4f s, sigma %.4f s, %s\n", output.result.time_offset.offset_s,
                output.result.time_offset.sigma_s, output.result.time_offset.applied ? "applied" : "not applied");
    testing::expect_within_sigma(output.result, antenna_from_lidar(drive), 4.0);
  }
}

/// At an even speed the offset is open, and with a setting of no x was stated as if there were none.
TEST(trajectory_method, positions_alone_at_an_even_speed_do_not_hide_an_offset_that_stays_in) {
  for (const int seed : {53, 54}) {
    simulator::SimulationOptions options = street(40.0);
    options.scenario = simulator::ScenarioKind::FigureEight;
    options.gnss.rate_hz = 5.0;
    options.gnss.noise_m = 0.02;
    options.speed_swing = 0.0;
    options.lidar_clock_offset_s = 0.1;
    options.seed = seed;
    const SimulatedDrive drive = testing::simulate_drive(options);
    Session session = with_poses(drive, 0.0);
    session.ins.clear();
    settings::Settings settings;
    settings.solve.apply_time_offset = calibration::ClockOffsetUse::No;
    const pipeline::PipelineOutput output = run({session}, settings);
    testing::error_of(output.result, antenna_from_lidar(drive));
    std::printf("  offset %.4f s, sigma %.4f s\n", output.result.time_offset.offset_s,
                output.result.time_offset.sigma_s);
    testing::expect_within_sigma(output.result, antenna_from_lidar(drive), 4.0);
    EXPECT_FALSE(output.result.time_offset.applied);
    for (const calibration::NamedQuantity& quantity : output.quantities)
      if (quantity.id == "lever arm x") {
        EXPECT_EQ(quantity.observed, output.result.known[calibration::Parameter::X].observed);
        EXPECT_TRUE(!quantity.observed || quantity.sigma == output.result.estimate(calibration::Parameter::X).sigma);
      }
  }
}

SimulatedDrive drive_in_an_eight(int seed) {
  simulator::SimulationOptions options = street(40.0);
  options.scenario = simulator::ScenarioKind::FigureEight;
  options.seed = seed;
  return testing::simulate_drive(options);
}

/// Whose odometry goes aside at every scan, in axes of the LiDAR.
Session with_drifting_poses(const SimulatedDrive& drive, double scale, const Eigen::Vector3d& aside_m) {
  Session session = with_poses(drive, scale);
  const std::vector<motion::StampedPose> straight = session.odometry_from_lidar;
  for (std::size_t i = 1; i < straight.size(); ++i) {
    RigidTransform step = straight[i - 1].pose.inverse() * straight[i].pose;
    step.translation() += aside_m;
    session.odometry_from_lidar[i].pose = session.odometry_from_lidar[i - 1].pose * step;
  }
  return session;
}

bool names_drift(const pipeline::PipelineOutput& output) {
  return std::ranges::any_of(output.findings, [](const drive::Finding& one) { return one.code == "odometry-drifts"; });
}

/// 3 mm at every scan, half a per cent of the way. Upwards, pitch was off by 11 sigma, and with a setting of no, where
/// it was not looked for, still is without this.
TEST(trajectory_method, an_odometry_that_rises_is_named_and_does_not_tilt_x) {
  for (const calibration::ClockOffsetUse use : {calibration::ClockOffsetUse::Auto, calibration::ClockOffsetUse::No})
    for (const int seed : {52, 55}) {
      const SimulatedDrive drive = drive_in_an_eight(seed);
      settings::Settings settings;
      settings.solve.apply_time_offset = use;
      const pipeline::PipelineOutput output = run({with_drifting_poses(drive, 0.0, {0.0, 0.0, 0.003})}, settings);
      testing::error_of(output.result, drive.ins_from_lidar);
      testing::expect_within_sigma(output.result, drive.ins_from_lidar, 4.0);
      EXPECT_TRUE(names_drift(output));
    }
}

/// It was said to drift to one side, by half of the scale, and the scale was not told any more.
TEST(trajectory_method, a_scale_of_the_odometry_is_no_drift) {
  for (const int seed : {58, 59})
    for (const double scale : {0.12, -0.1}) {
      const SimulatedDrive drive = drive_in_an_eight(seed);
      const pipeline::PipelineOutput output = run({with_poses(drive, scale)});
      testing::error_of(output.result, drive.ins_from_lidar);
      testing::expect_within_sigma(output.result, drive.ins_from_lidar, 4.0);
      EXPECT_FALSE(names_drift(output));
      const auto found =
          std::ranges::find(output.quantities, std::string("odometry scale"), &calibration::NamedQuantity::id);
      ASSERT_NE(found, output.quantities.end());
      std::printf("  scale %.4f (%.4f), sigma %.4f\n", found->value, 1.0 + scale, found->sigma);
      EXPECT_TRUE(found->observed);
      EXPECT_NEAR(found->value, 1.0 + scale, 4.0 * found->sigma);
    }
}

TEST(trajectory_method, poses_of_another_scale_are_named) {
  const calibration::CalibrationResult result = run({with_poses(testing::simulate_drive(street(30.0)), 1.5)}).result;
  EXPECT_EQ(result.status, calibration::Status::Inconsistent) << english(result.message);
  // Beside the INS the LiDAR goes a little farther in turns.
  EXPECT_NE(english(result.message).find("The way of the LiDAR is 2.5"), std::string::npos) << english(result.message);
}

TEST(trajectory_method, what_cannot_be_aligned_is_refused_or_said) {
  const SimulatedDrive drive = testing::simulate_drive(street(4.0));
  Session blind = with_poses(drive, 0.0), lost = blind;
  blind.odometry_from_lidar.clear();
  EXPECT_THROW(run({blind}), Error);
  lost.ins.clear();
  lost.gnss.clear();
  EXPECT_THROW(run({lost}), Error);
  EXPECT_THROW(run({}), Error);
  Session apart = with_poses(drive, 0.0);
  apart.gnss.clear();
  for (motion::InsSample& sample : apart.ins) sample.stamp_ns += 3'600'000'000'000;
  const pipeline::PipelineOutput output = run({apart});
  EXPECT_EQ(output.result.status, calibration::Status::NoUsableData) << english(output.result.message);
  EXPECT_EQ(output.result.message, say::trajectory_not_covered());
  bool told = false;
  for (const drive::Finding& finding : output.findings) told = told || finding.code == "trajectory-not-covered";
  EXPECT_TRUE(told);
}

TEST(trajectory_method, a_session_without_scans_may_have_an_empty_list_of_them) {
  class NoScans : public drive::ScanSource {
   public:
    std::size_t size() const override { return 0; }
    std::int64_t stamp_ns(std::size_t) const override {
      throw Error(ErrorCode::Contract, "", Message::verbatim("no such scan"));
    }
    std::string name(std::size_t) const override { return {}; }
    cloud::PointCloud load(std::size_t) const override { return {}; }
  };
  const SimulatedDrive drive = testing::simulate_drive(street(20.0));
  Session poses = with_poses(drive, 0.0), listed = poses;
  listed.scans = std::make_shared<NoScans>();
  const pipeline::PipelineOutput without = run({poses}), with = run({listed});
  EXPECT_TRUE(with.result.known[calibration::Parameter::X].observed) << english(with.result.message);
  EXPECT_EQ(with.result.mounting.reference_from_sensor.matrix(),
            without.result.mounting.reference_from_sensor.matrix());
}

TEST(trajectory_method, cancelled_runs_say_so) {
  const SimulatedDrive drive = testing::simulate_drive(street(4.0));
  pipeline::PipelineInput input;
  input.sessions.push_back(std::make_shared<Session>(drive.session));
  std::stop_source stop;
  stop.request_stop();
  Progress progress(stop.get_token());
  EXPECT_EQ(method_registry::calibration_method("trajectory").run(input, progress).result.status,
            calibration::Status::Cancelled);
}

TEST(trajectory_method, three_recorded_drives_agree_with_their_reference) {
  if (!std::filesystem::exists(testing::kData / "zxl19")) GTEST_SKIP() << "no recorded data at " << testing::kData;
  Progress progress;
  std::vector<Session> sessions;
  for (const char* bag : {"bag1", "bag2", "bag4"})
    sessions.push_back(formats::open_session(testing::kData / "zxl19" / bag, progress));
  settings::Settings settings;
  settings.solve.apply_time_offset = calibration::ClockOffsetUse::Yes;
  const pipeline::PipelineOutput output = run(sessions, settings);
  const testing::CalibrationError error = testing::error_of(output.result, testing::zxl19_reference());
  EXPECT_LE(error.rotation_deg, 0.5);
  EXPECT_LE(std::abs(error.x_m), 0.08);
  EXPECT_LE(std::abs(error.y_m), 0.08);
  expect_plots(output, 3);
}

TEST(trajectory_method, no_result_stands_on_an_attitude_that_contradicts_itself) {
  Session session = with_poses(testing::simulate_drive(street(20.0)), 0.0);
  EXPECT_TRUE(calibration::is_usable(run({session}).result));
  session.findings.push_back(
      {drive::Severity::Problem, "attitude-columns", session.name, Message::verbatim("Pitch and roll are exchanged.")});
  const calibration::CalibrationResult result = run({session}).result;
  EXPECT_EQ(result.status, calibration::Status::Inconsistent) << english(result.message);
  ASSERT_FALSE(result.advice.empty());
  EXPECT_NE(english(result.advice[0]).find("correct columns, signs and units"), std::string::npos)
      << english(result.advice[0]);
}

}  // namespace
}  // namespace remount::methods
