// Whole calibrations of simulated drives with known truth.
#include <gtest/gtest.h>

#include <algorithm>

#include "algorithms/core/error.h"
#include "algorithms/messages/render.h"
#include "messages/stages.h"
#include "model/results/result_file.h"
#include "model/simulator/simulator.h"
#include "tests/support/calibration_checks.h"
#include "tests/support/draws.h"
#include "tests/support/forwarded_scans.h"
#include "tests/support/kept_scans.h"

namespace remount::pipeline {

using simulator::ScenarioKind;
using simulator::SimulationOptions;

namespace {

struct Calibrated {
  simulator::SimulatedDrive drive;
  PipelineOutput output;
};

Calibrated calibrate_drive(const simulator::SimulatedDrive& drive, const settings::Settings& settings = {},
                           std::optional<RigidTransform> nominal = {}) {
  Calibrated run{drive, {}};
  PipelineInput input;
  input.sessions.push_back(std::make_shared<drive::Session>(run.drive.session));
  input.settings = settings;
  input.nominal_ins_from_lidar = nominal;
  Progress progress;
  run.output = run_pipeline(input, progress);
  return run;
}

Calibrated calibrate_simulated(const SimulationOptions& options, const settings::Settings& settings = {},
                               std::optional<RigidTransform> nominal = {}) {
  return calibrate_drive(testing::simulate_drive(options), settings, nominal);
}

SimulationOptions small(ScenarioKind scenario) {
  SimulationOptions options;
  options.scenario = scenario;
  options.beams = 32;
  options.azimuth_steps = 600;
  return options;
}

TEST(simulated_street, reaches_the_stated_accuracy_with_64_beams_and_no_nominal) {
  const Calibrated run = calibrate_simulated({});
  const testing::CalibrationError error = testing::error_of(run.output.result, run.drive.ins_from_lidar);
  EXPECT_EQ(run.output.result.status, calibration::Status::Ok) << english(run.output.result.message);
  EXPECT_LE(error.rotation_deg, 0.02);
  EXPECT_LE(std::abs(error.x_m), 0.005);
  EXPECT_LE(std::abs(error.y_m), 0.005);
  EXPECT_LE(std::abs(error.z_m), 0.03);
  testing::expect_within_sigma(run.output.result, run.drive.ins_from_lidar, 3.5);
  EXPECT_FALSE(run.output.result.candidates.empty());
}

TEST(simulated_street, is_solved_for_a_sensor_turned_by_180_degrees) {
  ONLY_IN_LONG_TESTS();
  SimulationOptions options = small(ScenarioKind::Street);
  options.ins_from_lidar = rigid_from_six({-0.4, 0.3, 0.9, degrees_to_radians(179.0), 0.02, -0.03});
  const Calibrated run = calibrate_simulated(options);
  const testing::CalibrationError error = testing::error_of(run.output.result, run.drive.ins_from_lidar);
  EXPECT_LE(error.rotation_deg, 0.03);
  EXPECT_LE(std::hypot(error.x_m, error.y_m), 0.01);
}

TEST(simulated_street, is_solved_for_a_sensor_turned_by_90_degrees) {
  SimulationOptions options = small(ScenarioKind::Street);
  options.ins_from_lidar = rigid_from_six({0.2, 0.1, 0.8, degrees_to_radians(-90.0), 0.0, 0.03});
  const Calibrated run = calibrate_simulated(options);
  const testing::CalibrationError error = testing::error_of(run.output.result, run.drive.ins_from_lidar);
  EXPECT_LE(error.rotation_deg, 0.03);
  EXPECT_LE(std::hypot(error.x_m, error.y_m), 0.01);
}

TEST(simulated_flat_ground, leaves_height_unobserved_and_the_rest_accurate_with_a_wrong_nominal) {
  SimulationOptions options = small(ScenarioKind::Flat);
  SixParameters nominal = six_from_rigid(options.ins_from_lidar);
  nominal.x_m += 0.1;
  nominal.y_m -= 0.1;
  nominal.z_m += 0.15;
  nominal.yaw_rad += 0.02;
  nominal.pitch_rad -= 0.02;
  nominal.roll_rad += 0.015;
  const Calibrated run = calibrate_simulated(options, {}, rigid_from_six(nominal));
  const calibration::CalibrationResult& result = run.output.result;
  const testing::CalibrationError error = testing::error_of(result, run.drive.ins_from_lidar);
  EXPECT_EQ(result.status, calibration::Status::Degenerate);
  EXPECT_FALSE(result.known[calibration::Parameter::Z].observed);
  EXPECT_FALSE(result.estimate(calibration::Parameter::Z).sigma.has_value());
  EXPECT_NEAR(result.mounting.reference_from_sensor.translation().z(), nominal.z_m, 1e-4) << "z stays at the nominal";
  EXPECT_LE(error.rotation_deg, 0.03);
  EXPECT_LE(std::abs(error.x_m), 0.008);
  EXPECT_LE(std::abs(error.y_m), 0.008);
  EXPECT_FALSE(result.advice.empty());
  testing::expect_within_sigma(result, run.drive.ins_from_lidar, 3.5);
}

TEST(simulated_straight_drive, claims_no_translation_and_no_roll) {
  const Calibrated run = calibrate_simulated(small(ScenarioKind::Straight));
  const calibration::CalibrationResult& result = run.output.result;
  testing::error_of(result, run.drive.ins_from_lidar);
  for (const std::size_t i : {0, 1, 2, 5})
    EXPECT_FALSE(result.known[calibration::kParameters[i]].observed) << to_string(calibration::kParameters[i]);
  EXPECT_TRUE(result.known[calibration::Parameter::Yaw].observed &&
              result.known[calibration::Parameter::Pitch].observed)
      << "yaw and pitch follow from the direction of travel";
  testing::expect_within_sigma(result, run.drive.ins_from_lidar, 3.5);
}

TEST(simulated_street, across_a_utm_zone_boundary_at_55_north_is_as_good_as_anywhere) {
  SimulationOptions options = small(ScenarioKind::Street);
  options.latitude_deg = 55.0;
  options.longitude_deg = 11.9997;
  options.heading_deg = 0.0;
  const Calibrated run = calibrate_simulated(options);
  const auto& ins = run.drive.session.ins;
  ASSERT_TRUE(ins.front().longitude_rad < degrees_to_radians(12.0) &&
              ins.back().longitude_rad > degrees_to_radians(12.0))
      << "the drive must cross the boundary: it ends at " << radians_to_degrees(ins.back().longitude_rad);
  const testing::CalibrationError error = testing::error_of(run.output.result, run.drive.ins_from_lidar);
  EXPECT_LE(error.rotation_deg, 0.02);
  EXPECT_LE(std::hypot(error.x_m, error.y_m), 0.007);
}

TEST(simulated_street, shows_and_removes_a_clock_offset_of_40_ms) {
  ONLY_IN_LONG_TESTS();
  SimulationOptions options = small(ScenarioKind::Street);
  options.lidar_clock_offset_s = 0.04;
  settings::Settings settings;
  settings.solve.apply_time_offset = calibration::ClockOffsetUse::No;
  const simulator::SimulatedDrive drive = testing::simulate_drive(options);
  const Calibrated without = calibrate_drive(drive, settings);
  testing::expect_within_sigma(without.output.result, without.drive.ins_from_lidar, 3.5);
  const testing::CalibrationError before = testing::error_of(without.output.result, without.drive.ins_from_lidar);
  EXPECT_NEAR(without.output.result.time_offset.offset_s, 0.04, 0.005);
  EXPECT_FALSE(without.output.result.time_offset.applied);
  settings.solve.apply_time_offset = calibration::ClockOffsetUse::Yes;
  const Calibrated with = calibrate_drive(drive, settings);
  const testing::CalibrationError after = testing::error_of(with.output.result, with.drive.ins_from_lidar);
  EXPECT_NEAR(with.output.result.time_offset.offset_s, 0.04, 0.005);
  EXPECT_TRUE(with.output.result.time_offset.applied);
  EXPECT_LE(after.rotation_deg, 0.03);
  EXPECT_LE(std::hypot(after.x_m, after.y_m), 0.012);
  EXPECT_LT(std::hypot(after.x_m, after.y_m), std::hypot(before.x_m, before.y_m));
  ASSERT_TRUE(without.output.clock_bias);
  EXPECT_FALSE(with.output.clock_bias);
  ASSERT_TRUE(without.output.result.estimate(calibration::Parameter::X).sigma &&
              with.output.result.estimate(calibration::Parameter::X).sigma);
  EXPECT_GT(*without.output.result.estimate(calibration::Parameter::X).sigma,
            10.0 * *with.output.result.estimate(calibration::Parameter::X).sigma);
  // A decision in the window solves again: the clocks differ as before.
  PipelineInput input;
  input.sessions.push_back(std::make_shared<drive::Session>(without.drive.session));
  input.settings.solve.apply_time_offset = calibration::ClockOffsetUse::No;
  PipelineOutput again = without.output;
  Progress progress;
  solve_again(input, again, progress);
  ASSERT_TRUE(again.result.estimate(calibration::Parameter::X).sigma);
  EXPECT_NEAR(*again.result.estimate(calibration::Parameter::X).sigma,
              *without.output.result.estimate(calibration::Parameter::X).sigma,
              0.2 * *without.output.result.estimate(calibration::Parameter::X).sigma);
  const auto warnings = std::count_if(again.findings.begin(), again.findings.end(),
                                      [](const drive::Finding& finding) { return finding.code == "clock-offset"; });
  EXPECT_EQ(warnings, 1);
}

// A source whose scan 30 cannot be read.
class BrokenScan final : public testing::ForwardedScans {
 public:
  using ForwardedScans::ForwardedScans;
  cloud::PointCloud load(std::size_t scan) const override {
    if (scan % 20 == 10) throw Error(ErrorCode::Format, "000010.pcd:3", Message::verbatim("WIDTH is not a number"));
    return ForwardedScans::load(scan);
  }
};

TEST(a_bad_scan, is_reported_and_skipped) {
  SimulationOptions options = small(ScenarioKind::Street);
  options.duration_s = 8.0;
  simulator::SimulatedDrive drive = testing::simulate_drive(options);
  drive.session.scans = std::make_shared<BrokenScan>(drive.session.scans);
  PipelineInput input;
  input.sessions.push_back(std::make_shared<drive::Session>(drive.session));
  input.settings.keyframes.distance_m = 0.5;
  input.nominal_ins_from_lidar = drive.ins_from_lidar;
  Progress progress;
  const PipelineOutput output = run_pipeline(input, progress);
  EXPECT_GT(output.result.pairs_accepted, 50);
  EXPECT_TRUE(std::any_of(output.findings.begin(), output.findings.end(), [](const drive::Finding& finding) {
    return finding.code == "scan-unreadable" && english(finding.explanation).find("WIDTH") != std::string::npos;
  }));
}

TEST(the_pipeline, calibrates_scans_and_lidar_poses_of_one_vehicle_together) {
  SimulationOptions options = small(ScenarioKind::Street);
  options.beams = 16;
  options.duration_s = 6.0;
  const simulator::SimulatedDrive drive = testing::simulate_drive(options);
  // The same drive as exact lidar poses: as somebody's odometry would deliver it.
  drive::Session poses = drive.session;
  poses.name = "poses";
  poses.scans.reset();
  for (const motion::StampedPose& pose : drive.enu_from_ins)
    poses.odometry_from_lidar.push_back({pose.stamp_ns, pose.pose * drive.ins_from_lidar});
  PipelineInput input;
  input.sessions = {std::make_shared<drive::Session>(drive.session), std::make_shared<drive::Session>(poses)};
  Progress progress;
  const PipelineOutput output = run_pipeline(input, progress);
  const testing::CalibrationError error = testing::error_of(output.result, drive.ins_from_lidar);
  EXPECT_LE(error.rotation_deg, 0.05);
  EXPECT_LE(std::hypot(error.x_m, error.y_m), 0.02);
  int from_poses = 0;
  for (const motion::Pair& pair : output.pairs)
    from_poses += output.keyframes[pair.keyframe_a].session == motion::SessionIndex{1} &&
                  pair.state == motion::PairState::Accepted;
  EXPECT_GT(from_poses, 10);
}

TEST(solving_again, leaves_the_output_as_it_was_when_cancelled) {
  SimulationOptions options = small(ScenarioKind::Street);
  options.beams = 16;
  options.duration_s = 4.0;
  const Calibrated run = calibrate_simulated(options);
  PipelineInput input;
  input.sessions.push_back(std::make_shared<drive::Session>(run.drive.session));
  PipelineOutput output = run.output;
  output.pairs[3].state = motion::PairState::Rejected;
  output.pairs[3].decided_by = motion::DecidedBy::User;
  std::stop_source stop;
  stop.request_stop();
  Progress cancelled(stop.get_token());
  EXPECT_FALSE(solve_again(input, output, cancelled)) << "nobody may take it for a solution";
  EXPECT_EQ(output.result.mounting.reference_from_sensor.matrix(),
            run.output.result.mounting.reference_from_sensor.matrix());
  Progress progress;
  EXPECT_TRUE(solve_again(input, output, progress));
  EXPECT_EQ(output.pairs[3].state, motion::PairState::Rejected) << "a user's decision stays";
  EXPECT_LT(rotation_angle_between_rad(output.result.mounting.reference_from_sensor, run.drive.ins_from_lidar), 1e-3);
}

TEST(solving_again, leaves_no_map_check_of_the_former_x_and_it_can_be_made_again) {
  SimulationOptions options = small(ScenarioKind::Street);
  options.beams = 16;
  options.duration_s = 6.0;
  const Calibrated run = calibrate_simulated(options);
  ASSERT_EQ(run.output.map_check, MapCheck::Made);
  PipelineInput input;
  input.sessions.push_back(std::make_shared<drive::Session>(run.drive.session));
  PipelineOutput output = run.output;
  output.pairs[3].state = motion::PairState::Rejected;
  output.pairs[3].decided_by = motion::DecidedBy::User;
  PipelineOutput at_once = output;
  Progress progress;
  ASSERT_TRUE(solve_at_once(input, at_once, progress));
  EXPECT_TRUE(at_once.sharpness.empty()) << "X has moved";
  EXPECT_EQ(at_once.map_check, MapCheck::Moved);
  ASSERT_TRUE(solve_again(input, output, progress));
  EXPECT_TRUE(output.sharpness.empty());
  EXPECT_EQ(output.map_check, MapCheck::Moved);
  check_map(input, output, progress);
  ASSERT_EQ(output.map_check, MapCheck::Made);
  EXPECT_NEAR(output.sharpness.front().sharpness.plane_thickness_m,
              run.output.sharpness.front().sharpness.plane_thickness_m,
              0.1 * run.output.sharpness.front().sharpness.plane_thickness_m);
}

TEST(the_pipeline, says_why_there_is_no_map_check) {
  SimulationOptions options = small(ScenarioKind::Street);
  options.beams = 16;
  options.duration_s = 4.0;
  settings::Settings settings;
  settings.run.map_check = false;
  EXPECT_EQ(calibrate_simulated(options, settings).output.map_check, MapCheck::SwitchedOff);
}

TEST(the_pipeline, cancelled_in_its_second_pass_keeps_the_pairs_of_the_first) {
  SimulationOptions options = small(ScenarioKind::Street);
  options.beams = 16;
  options.duration_s = 5.0;
  const simulator::SimulatedDrive drive = testing::simulate_drive(options);
  PipelineInput input;
  input.sessions.push_back(std::make_shared<drive::Session>(drive.session));
  // So far off that the scans are compensated a second time through the X found.
  input.nominal_ins_from_lidar = perturb(drive.ins_from_lidar, (Vector6d() << 0.1, 0.1, 0, 0, 0, 0.03).finished());
  std::stop_source stop;
  int begun = 0;
  Progress progress(stop.get_token(), [&](const ProgressUpdate& update) {
    if (update.stage != say::stage_registering_pairs) return;
    begun += update.done == 1;
    if (begun == 2 && update.done > update.total / 2) stop.request_stop();
  });
  const PipelineOutput output = run_pipeline(input, progress);
  ASSERT_EQ(begun, 2) << "there was no second pass to cancel";
  ASSERT_EQ(output.result.status, calibration::Status::Cancelled);
  EXPECT_EQ(output.compensation_ins_from_lidar.matrix(), input.nominal_ins_from_lidar->matrix());
  for (const motion::Pair& pair : output.pairs) EXPECT_FALSE(motion::is_cancelled(pair.registration));
}

TEST(the_pipeline, gives_the_same_numbers_for_any_number_of_threads) {
  SimulationOptions options = small(ScenarioKind::Street);
  options.duration_s = 4.0;
  options.beams = 16;
  const simulator::SimulatedDrive drive = testing::simulate_drive(options);
  PipelineInput input;
  input.sessions.push_back(std::make_shared<drive::Session>(drive.session));
  input.settings.solve.max_listed_candidates = 7;
  Progress progress;
  input.threads = 1;
  const PipelineOutput one = run_pipeline(input, progress);
  input.threads = 3;
  const PipelineOutput three = run_pipeline(input, progress);
  EXPECT_EQ(one.result.mounting.reference_from_sensor.matrix(), three.result.mounting.reference_from_sensor.matrix());
  EXPECT_EQ(one.pairs.size(), three.pairs.size());
  ASSERT_TRUE(calibration::is_usable(one.result)) << english(one.result.message);
  EXPECT_EQ(one.result.candidates.size(), 7U) << "as many as the option allows";
  EXPECT_EQ(std::count_if(one.result.candidates.begin(), one.result.candidates.end(),
                          [](const calibration::Candidate& candidate) {
                            return candidate.source == calibration::MountingSource::JointClouds;
                          }),
            1)
      << "the X that is exported is listed wherever it ranks";
}

TEST(the_pipeline, stops_when_cancelled) {
  std::stop_source stop;
  stop.request_stop();
  PipelineInput input;
  input.sessions.push_back(
      std::make_shared<drive::Session>(testing::simulate_drive(small(ScenarioKind::Street)).session));
  Progress progress(stop.get_token());
  const calibration::CalibrationResult result = run_pipeline(input, progress).result;
  EXPECT_EQ(result.status, calibration::Status::Cancelled);
  EXPECT_GT(result.pairs_proposed, 0) << "what was found until then is counted";
}

TEST(the_pipeline, refuses_a_nominal_outside_the_search_range) {
  SimulationOptions options = small(ScenarioKind::Street);
  options.duration_s = 2.0;
  PipelineInput input;
  input.sessions.push_back(std::make_shared<drive::Session>(testing::simulate_drive(options).session));
  input.settings.range.pitch_max_rad = 0.1;
  input.nominal_ins_from_lidar = rigid_from_six({0, 0, 0, 0, degrees_to_radians(20.0), 0});
  Progress progress;
  try {
    run_pipeline(input, progress);
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::Contract);
    EXPECT_NE(english(error.what_happened()).find("pitch 20.00 deg (at most 5.73 deg)"), std::string::npos)
        << error.what();
  }
}

}  // namespace
}  // namespace remount::pipeline
