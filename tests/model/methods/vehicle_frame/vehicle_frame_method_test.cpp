// The method on simulated drives with known truth, and what it refuses.
#include "model/methods/vehicle_frame/vehicle_frame_method.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "algorithms/core/error.h"
#include "algorithms/messages/render.h"
#include "model/pipeline/pipeline.h"
#include "model/simulator/road.h"
#include "model/simulator/simulator.h"
#include "tests/support/calibration_checks.h"
#include "tests/support/draws.h"
#include "tests/support/findings.h"
#include "tests/support/noisy_odometry.h"

namespace remount::methods {

using simulator::ScenarioKind;

namespace {

struct Drive {
  std::shared_ptr<drive::Session> session;
  RigidTransform vehicle_from_lidar;
};

/// A drive whose LiDAR's poses come from an odometry with errors of `way_m` and `turn_rad` a step, in units of `scale`.
Drive simulated(ScenarioKind scenario, double scale = 1.0, double way_m = 0.003, double turn_rad = 2e-4,
                double speed_mps = 8.0) {
  simulator::SimulationOptions options;
  options.scenario = scenario;
  options.duration_s = 120.0;
  options.speed_mps = speed_mps;
  const simulator::SimulatedDrive drive = simulator::simulate_drive(options);
  Drive out;
  out.vehicle_from_lidar = simulator::vehicle_from_ins(scenario) * drive.ins_from_lidar;
  out.session = std::make_shared<drive::Session>(drive.session);
  out.session->scans = nullptr;
  out.session->odometry_from_lidar = testing::noisy_odometry(drive, way_m, turn_rad, 5, scale);
  return out;
}

pipeline::PipelineOutput run(const Drive& drive, const settings::Settings& settings = {}) {
  pipeline::PipelineInput input;
  input.sessions = {drive.session};
  input.settings = settings;
  Progress progress;
  return run_vehicle_frame(input, progress);
}

TEST(vehicle_frame_method, a_hilly_drive_determines_all_six_parameters) {
  const Drive drive = simulated(ScenarioKind::Hill);
  const pipeline::PipelineOutput output = run(drive);
  const testing::CalibrationError error = testing::error_of(output.result, drive.vehicle_from_lidar);
  testing::expect_within_sigma(output.result, drive.vehicle_from_lidar, 4.0);
  EXPECT_EQ(output.result.status, calibration::Status::Ok) << english(output.result.message);
  EXPECT_EQ(output.method, "vehicle-frame");
  EXPECT_EQ(output.result.mounting.reference, calibration::BodyFrame::Vehicle);
  EXPECT_LT(error.rotation_deg, 0.1);
  EXPECT_LT(std::abs(error.x_m), 0.02);
  EXPECT_LT(std::abs(error.y_m), 0.02);
  EXPECT_LT(std::abs(error.z_m), 0.05);
  ASSERT_EQ(output.plots.size(), 3u);
  EXPECT_EQ(output.plots[0].curves.size(), 4u);
  for (const calibration::Curve& curve : output.plots[0].curves)
    EXPECT_EQ(curve.z.size(), curve.x.size()) << curve.name;
  // The closed form stays with the sensor, planar integration does not.
  const auto& off = output.plots[2].curves;
  EXPECT_LT(off[0].y.back(), off[2].y.back());
}

void turn_wheels_around(drive::Session& session) {
  for (motion::WheelSample& wheel : session.wheels) {
    wheel.rear_left_mps = -wheel.rear_left_mps;
    wheel.rear_right_mps = -wheel.rear_right_mps;
  }
}

void drop_ins(drive::Session& session) {
  session.ins.clear();
  session.world_from_ins.clear();
}

TEST(vehicle_frame_method, wheels_that_turn_the_wrong_way_are_refused) {
  ONLY_IN_LONG_TESTS();
  for (const ScenarioKind scenario : {ScenarioKind::Hill, ScenarioKind::FigureEight, ScenarioKind::Street})
    for (const bool ins : {true, false}) {  // without an INS the IMU's forces tell it
      const Drive drive = simulated(scenario);
      if (!ins) drop_ins(*drive.session);
      const pipeline::PipelineOutput right = run(drive);
      EXPECT_TRUE(calibration::is_usable(right.result)) << right.result.message;
      turn_wheels_around(*drive.session);
      const pipeline::PipelineOutput output = run(drive);
      std::printf("  %s\n", english(output.result.message).c_str());
      EXPECT_EQ(output.result.status, calibration::Status::Inconsistent) << output.result.message;
      EXPECT_EQ(calibration::parameter_names(output.result.observed()), "");
    }
}

void turn_imu_upside_down(drive::Session& session) {
  for (motion::ImuSample& sample : session.imu)
    for (const int axis : {1, 2}) sample.angular_rate_radps[axis] *= -1.0, sample.specific_force_mps2[axis] *= -1.0;
}

// One speed of the wheels does not tell which way a turn is: without an INS, forces alone tell what is up.
TEST(vehicle_frame_method, an_imu_upside_down_is_refused_until_its_mounting_is_stated) {
  for (const ScenarioKind scenario : {ScenarioKind::Hill, ScenarioKind::FigureEight, ScenarioKind::Street})
    for (const double known_deg : {5.0, 180.0}) {
      const Drive drive = simulated(scenario);
      drop_ins(*drive.session);
      for (motion::WheelSample& wheel : drive.session->wheels)
        wheel.rear_left_mps = wheel.rear_right_mps = 0.5 * (wheel.rear_left_mps + wheel.rear_right_mps);
      turn_imu_upside_down(*drive.session);
      settings::Settings settings;
      settings.vehicle_frame.imu_mounting_sigma_deg = known_deg;
      const pipeline::PipelineOutput output = run(drive, settings);
      std::printf("  known to %g deg: %s\n", known_deg, english(output.result.message).c_str());
      EXPECT_EQ(output.result.status, calibration::Status::Inconsistent) << output.result.message;
      EXPECT_EQ(output.result.message.code(), "vehicle-imu-upside-down");
      EXPECT_EQ(calibration::parameter_names(output.result.observed()), "");
      settings.vehicle_frame.imu_mounting_sigma_deg = 5.0;
      settings.vehicle_frame.imu_roll_deg = 180.0;
      const pipeline::PipelineOutput stated = run(drive, settings);
      EXPECT_TRUE(calibration::is_usable(stated.result)) << stated.result.message;
      EXPECT_LT(testing::error_of(stated.result, drive.vehicle_from_lidar).rotation_deg, 0.5);
    }
}

// At walking pace bends press little: they do all the same, and on the right side where the wheels are right.
TEST(vehicle_frame_method, wheels_that_turn_the_wrong_way_slowly_are_refused_by_forces) {
  const Drive drive = simulated(ScenarioKind::FigureEight, 1.0, 0.003, 2e-4, 2.0);
  drop_ins(*drive.session);
  EXPECT_NE(run(drive).result.status, calibration::Status::Inconsistent);
  turn_wheels_around(*drive.session);
  const pipeline::PipelineOutput output = run(drive);
  EXPECT_EQ(output.result.status, calibration::Status::Inconsistent) << output.result.message;
}

TEST(vehicle_frame_method, a_vehicle_that_reverses_all_along_is_not_refused) {
  // The same drive run backwards in time: speeds and rates change their signs, forces and places do not.
  for (const bool ins : {true, false}) {
    const Drive drive = simulated(ScenarioKind::FigureEight);
    drive::Session& session = *drive.session;
    const std::int64_t end_ns = session.imu.back().stamp_ns;
    const auto reverse = [&](auto& samples) {
      std::reverse(samples.begin(), samples.end());
      for (auto& sample : samples) sample.stamp_ns = end_ns - sample.stamp_ns;
    };
    reverse(session.imu);
    reverse(session.wheels);
    reverse(session.ins);
    reverse(session.odometry_from_lidar);
    for (motion::ImuSample& sample : session.imu) sample.angular_rate_radps = -sample.angular_rate_radps;
    turn_wheels_around(session);
    if (!ins) drop_ins(session);
    const pipeline::PipelineOutput output = run(drive);
    EXPECT_TRUE(calibration::is_usable(output.result)) << output.result.message;
    EXPECT_LT(testing::error_of(output.result, drive.vehicle_from_lidar).rotation_deg, 0.5);
  }
}

TEST(vehicle_frame_method, a_gyro_and_a_tyre_that_are_off_are_named_and_allowed_for) {
  const Drive drive = simulated(ScenarioKind::Street);
  for (motion::ImuSample& sample : drive.session->imu) sample.angular_rate_radps *= 1.01;
  for (motion::WheelSample& wheel : drive.session->wheels) wheel.rear_left_mps *= 1.03;
  const pipeline::PipelineOutput output = run(drive);
  testing::expect_within_sigma(output.result, drive.vehicle_from_lidar, 4.0);
  std::printf("  %s\n  %s\n", testing::said_of(output.findings, "gyro-scale").c_str(),
              testing::said_of(output.findings, "wheel-sides").c_str());
  EXPECT_TRUE(testing::has_code(output.findings, "gyro-scale"));
  EXPECT_TRUE(testing::has_code(output.findings, "wheel-sides"));
  const pipeline::PipelineOutput clean = run(simulated(ScenarioKind::Street));
  EXPECT_FALSE(testing::has_code(clean.findings, "gyro-scale"));
  EXPECT_FALSE(testing::has_code(clean.findings, "wheel-sides"));
}

TEST(vehicle_frame_method, flat_ground_leaves_the_height_open) {
  const Drive drive = simulated(ScenarioKind::Flat);
  const pipeline::PipelineOutput output = run(drive);
  const testing::CalibrationError error = testing::error_of(output.result, drive.vehicle_from_lidar);
  testing::expect_within_sigma(output.result, drive.vehicle_from_lidar, 4.0);
  EXPECT_FALSE(output.result.known[calibration::Parameter::Z].observed);
  EXPECT_FALSE(output.result.estimate(calibration::Parameter::Z).sigma);
  EXPECT_LT(std::abs(error.x_m), 0.02);
  EXPECT_LT(std::abs(error.y_m), 0.02);
  EXPECT_LT(error.rotation_deg, 0.1);
}

TEST(vehicle_frame_method, poses_without_scale_get_one) {
  const Drive drive = simulated(ScenarioKind::Hill, 3.7);
  settings::Settings settings;
  settings.vehicle_frame.scale = calibration::ScaleMode::Estimated;
  const pipeline::PipelineOutput output = run(drive, settings);
  ASSERT_FALSE(output.quantities.empty());
  EXPECT_EQ(output.quantities[0].id, "scale");
  std::cout << "  scale 3.7 found as " << output.quantities[0].value << "\n";
  EXPECT_NEAR(output.quantities[0].value / 3.7, 1.0, 0.005);
}

TEST(vehicle_frame_method, poses_of_another_scale_are_named_where_the_scale_is_said_to_be_known) {
  for (const double scale : {2.5, 0.4}) {
    const calibration::CalibrationResult result = run(simulated(ScenarioKind::Hill, scale)).result;
    EXPECT_EQ(result.status, calibration::Status::Inconsistent) << english(result.message);
    EXPECT_NE(english(result.message).find("2.50 times as long"), std::string::npos) << english(result.message);
    EXPECT_EQ(
        english(result.message).find(scale > 1.0 ? "The way of the wheels is" : "The way by the sensor's poses is"), 0u)
        << english(result.message);
    ASSERT_EQ(result.advice.size(), 1u);
    EXPECT_NE(english(result.advice[0]).find("estimated"), std::string::npos) << english(result.advice[0]);
  }
}

TEST(vehicle_frame_method, wheels_that_measure_wrongly_by_more_than_tyres_are_named) {
  for (const double scale : {1.0, 1.08}) {
    const pipeline::PipelineOutput output = run(simulated(ScenarioKind::Hill, scale));
    bool told = false;
    for (const drive::Finding& finding : output.findings) told = told || finding.code == "wheel-scale";
    EXPECT_EQ(told, scale > 1.0) << english(output.result.message);
    EXPECT_TRUE(calibration::is_usable(output.result)) << english(output.result.message);
  }
}

TEST(vehicle_frame_method, scans_become_poses_by_the_lidars_own_odometry) {
  simulator::SimulationOptions options;
  options.scenario = ScenarioKind::Hill;
  options.duration_s = 40.0;
  options.speed_mps = 8.0;
  options.beams = 16;
  options.azimuth_steps = 450;
  options.scan_rate_hz = 5.0;
  const simulator::SimulatedDrive simulated_drive = simulator::simulate_drive(options);
  const Drive drive{std::make_shared<drive::Session>(simulated_drive.session),
                    simulator::vehicle_from_ins(options.scenario) * simulated_drive.ins_from_lidar};
  const pipeline::PipelineOutput output = run(drive);
  const testing::CalibrationError error = testing::error_of(output.result, drive.vehicle_from_lidar);
  ASSERT_TRUE(output.result.status == calibration::Status::Ok ||
              output.result.status == calibration::Status::Degenerate)
      << english(output.result.message);
  testing::expect_within_sigma(output.result, drive.vehicle_from_lidar, 4.0);
  for (const std::size_t i : {0u, 1u, 3u, 4u})
    EXPECT_TRUE(output.result.known[calibration::kParameters[i]].observed) << to_string(calibration::kParameters[i]);
  EXPECT_LT(error.rotation_deg, 0.3);
  EXPECT_LT(std::hypot(error.x_m, error.y_m), 0.1);
}

TEST(vehicle_frame_method, without_an_imu_the_ins_stands_in) {
  const Drive drive = simulated(ScenarioKind::Hill);
  drive.session->imu.clear();
  const pipeline::PipelineOutput output = run(drive);
  const testing::CalibrationError error = testing::error_of(output.result, drive.vehicle_from_lidar);
  testing::expect_within_sigma(output.result, drive.vehicle_from_lidar, 4.0);
  EXPECT_LT(error.rotation_deg, 0.2);
  drive.session->ins.clear();
  EXPECT_THROW(run(drive), Error);
}

TEST(vehicle_frame_method, an_attitude_that_contradicts_itself_is_blamed_where_turns_are_taken_from_it) {
  const Drive drive = simulated(ScenarioKind::Hill);
  drive.session->findings.push_back({drive::Severity::Problem, "attitude-columns", std::string("drive"),
                                     Message::verbatim("Pitch and roll are exchanged.")});
  EXPECT_TRUE(calibration::is_usable(run(drive).result)) << "an IMU tells how it turns";
  drive.session->imu.clear();
  EXPECT_EQ(run(drive).result.status, calibration::Status::Inconsistent);
}

TEST(vehicle_frame_method, missing_streams_are_named) {
  Drive drive = simulated(ScenarioKind::Flat);
  drive.session->wheels.clear();
  try {
    run(drive);
    FAIL() << "wheels were not missed";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::Unsupported);
    EXPECT_NE(std::string(error.what()).find("wheel"), std::string::npos);
  }
  pipeline::PipelineInput none;
  Progress progress;
  EXPECT_THROW(run_vehicle_frame(none, progress), Error);
}

}  // namespace
}  // namespace remount::methods
