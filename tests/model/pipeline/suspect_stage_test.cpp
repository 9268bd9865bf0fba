#include "model/pipeline/suspect_stage.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "algorithms/messages/render.h"
#include "model/results/result_file.h"
#include "model/simulator/simulator.h"
#include "tests/support/draws.h"
#include "tests/support/findings.h"
#include "tests/support/kept_scans.h"

namespace remount::pipeline {

using simulator::ScenarioKind;

namespace {

/// What the chained scans of that drive tell, with stamps that are early by `offset_s`.
std::vector<drive::Finding> clocks_of(ScenarioKind scenario, double offset_s) {
  simulator::SimulationOptions options;
  options.scenario = scenario;
  options.duration_s = 60.0;
  options.beams = 4;
  options.azimuth_steps = 20;
  const simulator::SimulatedDrive drive = testing::simulate_drive(options);
  const DriveMotion motion({std::make_shared<const drive::Session>(drive.session)});
  std::vector<motion::StampedPose> poses;
  for (const motion::StampedPose& pose : drive.enu_from_ins)
    poses.push_back(
        {pose.stamp_ns - std::llround(offset_s * 1e9),
         (drive.enu_from_ins.front().pose * drive.ins_from_lidar).inverse() * pose.pose * drive.ins_from_lidar});
  std::vector<drive::Finding> findings;
  if (const auto far = find_far_clock(motion, motion::SessionIndex{0}, poses)) findings.push_back(far->finding);
  for (const drive::Finding& finding : findings)
    std::printf("[%s] %s\n", finding.code.c_str(), english(finding.explanation).c_str());
  return findings;
}

TEST(suspect_stage, clocks_that_are_far_apart_are_named_with_the_offset) {
  EXPECT_NE(testing::said_of(clocks_of(ScenarioKind::Street, 0.5), "clock-far").find("0.50"), std::string::npos);
  EXPECT_NE(testing::said_of(clocks_of(ScenarioKind::Street, 0.5), "clock-far").find("s later"), std::string::npos);
  EXPECT_NE(testing::said_of(clocks_of(ScenarioKind::Street, -0.5), "clock-far").find("s earlier"), std::string::npos);
}

TEST(suspect_stage, leap_seconds_are_named_where_the_road_never_repeats_itself) {
  drive::Session session;
  session.name = "drive";
  std::vector<motion::StampedPose> poses;
  for (int i = 0; i < 1200; ++i) {
    const double t = 0.1 * i;
    const RigidTransform pose = make_rigid(
        rotation_from_yaw_pitch_roll({1.5 * std::sin(0.31 * t) + 0.8 * std::sin(0.83 * t + 1.0), 0.0, 0.0}), {t, 0, 0});
    session.world_from_ins.push_back({i * 100'000'000LL, pose});
    poses.push_back({i * 100'000'000LL - 18'000'000'000LL, pose});
  }
  const DriveMotion motion({std::make_shared<const drive::Session>(session)});
  std::vector<drive::Finding> findings;
  if (const auto far = find_far_clock(motion, motion::SessionIndex{0}, poses)) findings.push_back(far->finding);
  EXPECT_NE(testing::said_of(findings, "clock-far").find("18.00 s later"), std::string::npos)
      << testing::said_of(findings, "clock-far");
  EXPECT_NE(testing::said_of(findings, "clock-far").find("GPS time is 18 s ahead of UTC"), std::string::npos);
}

TEST(suspect_stage, clocks_that_agree_or_cannot_be_told_are_silent) {
  for (const ScenarioKind scenario :
       {ScenarioKind::Street, ScenarioKind::Flat, ScenarioKind::Straight, ScenarioKind::FigureEight,
        ScenarioKind::ParkingRamp, ScenarioKind::Hill, ScenarioKind::Highway, ScenarioKind::Tunnel})
    for (const double offset_s : {0.0, 0.03, -0.1})
      EXPECT_TRUE(clocks_of(scenario, offset_s).empty()) << static_cast<int>(scenario) << " " << offset_s;
}

/// A drive whose pairs of scans were registered to a thirtieth of a degree; its INS is logged `ins_early_s` too early.
struct RegisteredDrive {
  DriveMotion motion;
  PipelineOutput output;
};
RegisteredDrive registered(double ins_early_s, ScenarioKind scenario = ScenarioKind::FigureEight) {
  std::mt19937 random(5);
  std::normal_distribution<double> noise(0.0, 5e-4);
  simulator::SimulationOptions options;
  options.scenario = scenario;
  options.duration_s = 40.0;
  options.beams = 4;
  options.azimuth_steps = 20;
  simulator::SimulatedDrive drive = testing::simulate_drive(options);
  for (motion::InsSample& sample : drive.session.ins) sample.stamp_ns -= std::llround(1e9 * ins_early_s);
  RegisteredDrive out{DriveMotion({std::make_shared<const drive::Session>(drive.session)}), {}};
  for (std::size_t k = 0; k < drive.enu_from_ins.size(); k += 5) {
    const motion::StampedPose& pose = drive.enu_from_ins[k];
    out.output.keyframes.push_back({motion::SessionIndex{0}, motion::ScanIndex(k), pose.stamp_ns, 0.0});
    if (k == 0) continue;
    motion::Pair pair;
    pair.keyframe_a = motion::KeyframeIndex(out.output.keyframes.size() - 2);
    pair.keyframe_b = motion::KeyframeIndex(pair.keyframe_a + 1);
    pair.lidar_b_from_lidar_a =
        (pose.pose * drive.ins_from_lidar).inverse() * drive.enu_from_ins[k - 5].pose * drive.ins_from_lidar;
    pair.lidar_b_from_lidar_a.rotate(so3_exp({noise(random), noise(random), noise(random)}));
    pair.registration.attempted = pair.registration.converged = true;
    pair.registration.information.setIdentity();
    out.output.pairs.push_back(pair);
  }
  return out;
}

TEST(suspect_stage, registered_pairs_refute_a_clock_that_chained_scans_suspect) {
  const auto findings_of = [](double ins_early_s, double suspected_s,
                              ScenarioKind scenario = ScenarioKind::FigureEight) {
    RegisteredDrive drive = registered(ins_early_s, scenario);
    report_far_clocks(drive.motion,
                      {{motion::SessionIndex{0},
                        suspected_s,
                        {drive::Severity::Problem, "clock-far", std::string("drive"), Message::verbatim("suspected")}}},
                      drive.output);
    return testing::said_of(drive.output.findings, "clock-far");
  };
  EXPECT_EQ(findings_of(0.0, 3.0), "") << "the pairs turn as the INS does at their own stamps";
  EXPECT_EQ(findings_of(-3.0, 3.0), "suspected");
  EXPECT_EQ(findings_of(0.0, 100.0), "suspected") << "the INS was not recorded then: nothing refutes it";
  EXPECT_EQ(findings_of(0.0, 3.0, ScenarioKind::Straight), "suspected") << "one stretch turns like any other";
}

TEST(suspect_stage, registered_pairs_confirm_leap_seconds_between_recordings_that_lie_apart) {
  for (const double ins_early_s : {0.0, 18.0, -19.0}) {
    RegisteredDrive drive = registered(ins_early_s);
    report_far_clocks(drive.motion, {}, drive.output);
    EXPECT_EQ(testing::said_of(drive.output.findings, "clock-far"), "") << "the recordings do not lie apart";
    drive.output.findings = {
        {drive::Severity::Warning, "clock-leap-seconds", drive.motion.session(motion::SessionIndex{0}).name, {}}};
    report_far_clocks(drive.motion, {}, drive.output);
    const std::string far = testing::said_of(drive.output.findings, "clock-far");
    if (ins_early_s == 0.0)
      EXPECT_EQ(far, "");
    else
      EXPECT_NE(far.find(ins_early_s > 0.0 ? "18 s earlier" : "19 s later"), std::string::npos) << far;
  }
}

TEST(suspect_stage, nothing_is_claimed_of_a_drive_whose_clocks_are_apart) {
  calibration::CalibrationResult result;
  result.status = calibration::Status::Ok;
  result.set_observed(calibration::ParameterSet::all(), {});
  result.covariance = Matrix6d::Identity();
  blame_recording({{drive::Severity::Problem, "clock-far", std::string("drive"), {}}}, result);
  EXPECT_EQ(result.status, calibration::Status::Inconsistent);
  EXPECT_EQ(calibration::parameter_names(result.observed()), "");
  EXPECT_FALSE(result.estimate(calibration::Parameter::X).sigma);
}

TEST(suspect_stage, of_several_sessions_the_worst_clock_decides) {
  calibration::CalibrationResult result;
  result.status = calibration::Status::Ok;
  result.set_observed(calibration::ParameterSet::all(), {});
  blame_recording({{drive::Severity::Warning, "clock-far", std::string("first"), {}},
                   {drive::Severity::Problem, "clock-far", std::string("second"), {}}},
                  result);
  EXPECT_EQ(result.status, calibration::Status::Inconsistent);
}

TEST(suspect_stage, positions_of_an_antenna_are_advice_of_the_result) {
  calibration::CalibrationResult result;
  result.status = calibration::Status::Ok;
  result.set_observed(calibration::ParameterSet::all(), {});
  blame_recording({{drive::Severity::Warning, "antenna-position", std::string("drive"), {}}}, result);
  EXPECT_EQ(result.status, calibration::Status::Ok);
  ASSERT_EQ(result.advice.size(), 1U);
  EXPECT_NE(english(result.advice[0]).find("antenna"), std::string::npos);
}

TEST(suspect_stage, without_a_result_the_clock_is_the_only_advice) {
  calibration::CalibrationResult failed;
  failed.status = calibration::Status::TooFewPairs;
  failed.advice = {Message::verbatim("Drive turns.")};
  blame_recording({{drive::Severity::Problem, "clock-far", std::string("drive"), {}}}, failed);
  ASSERT_EQ(failed.advice.size(), 1U);
  EXPECT_NE(english(failed.advice[0]).find("bring the clocks of LiDAR and INS together"), std::string::npos);
  calibration::CalibrationResult other = failed;
  other.advice = {Message::verbatim("Drive turns.")};
  blame_recording({}, other);
  EXPECT_EQ(english(other.advice), std::vector<std::string>{"Drive turns."});
}

TEST(suspect_stage, a_result_stands_on_clocks_that_are_far_apart_only_where_they_were_brought_together) {
  const auto blamed = [](drive::Severity severity, std::vector<double> applied_s) {
    calibration::CalibrationResult result;
    result.status = calibration::Status::Ok;
    result.set_observed(calibration::ParameterSet::all(), {});
    result.time_offset.applied = !applied_s.empty();
    result.session_time_offset_s = std::move(applied_s);
    blame_recording({{severity, "clock-far", std::string("drive"), {}}}, result);
    EXPECT_EQ(result.advice.size(), 1U);
    return result.status;
  };
  EXPECT_EQ(blamed(drive::Severity::Problem, {}), calibration::Status::Inconsistent);
  EXPECT_EQ(blamed(drive::Severity::Problem, {0.05}), calibration::Status::Inconsistent)
      << "that is not the offset that was found";
  EXPECT_EQ(blamed(drive::Severity::Problem, {0.001, -0.4}), calibration::Status::Ok);
  EXPECT_EQ(blamed(drive::Severity::Warning, {}), calibration::Status::Ok);
}

PipelineOutput calibrated(const simulator::SimulatedDrive& drive, bool nominal) {
  PipelineInput input;
  input.sessions = {std::make_shared<const drive::Session>(drive.session)};
  if (nominal) input.nominal_ins_from_lidar = drive.ins_from_lidar;
  input.settings.pairing.max_partners = 4;
  input.settings.run.map_check = false;
  Progress progress;
  PipelineOutput output = run_pipeline(input, progress);
  std::printf("%s\n", english(output.result.message).c_str());
  for (const std::string& advice : english(output.result.advice)) std::printf("  %s\n", advice.c_str());
  for (const drive::Finding& finding : output.findings)
    std::printf("  [%s] %s\n", finding.code.c_str(), english(finding.explanation).c_str());
  return output;
}

simulator::SimulationOptions small_drive() {
  simulator::SimulationOptions options;
  options.beams = 16;
  options.azimuth_steps = 360;
  options.duration_s = 14.0;
  return options;
}

TEST(suspect_stage, a_calibration_without_nominal_names_the_clock_that_is_off) {
  ONLY_IN_LONG_TESTS();
  simulator::SimulationOptions options = small_drive();
  options.lidar_clock_offset_s = 0.5;
  const PipelineOutput output = calibrated(testing::simulate_drive(options), false);
  EXPECT_NE(testing::said_of(output.findings, "clock-far"), "");
  ASSERT_FALSE(output.result.advice.empty());
  EXPECT_NE(english(output.result.advice[0]).find("bring the clocks"), std::string::npos)
      << english(output.result.advice[0]);
  options.lidar_clock_offset_s = 0.0;
  EXPECT_EQ(testing::said_of(calibrated(testing::simulate_drive(options), false).findings, "clock-far"), "");
}

TEST(suspect_stage, scans_that_turn_otherwise_than_pitch_and_roll_say_give_no_result) {
  simulator::SimulatedDrive drive = testing::simulate_drive(small_drive());
  EXPECT_EQ(testing::said_of(calibrated(drive, true).findings, "attitude-columns"), "");
  for (motion::InsSample& sample : drive.session.ins) {
    YawPitchRoll angles = yaw_pitch_roll_from_rotation(sample.enu_from_ins.toRotationMatrix());
    angles.roll_rad = -angles.roll_rad;
    sample.enu_from_ins = Eigen::Quaterniond(rotation_from_yaw_pitch_roll(angles));
  }
  const PipelineOutput output = calibrated(drive, true);
  EXPECT_NE(testing::said_of(output.findings, "attitude-columns"), "");
  EXPECT_FALSE(calibration::is_usable(output.result));
}

TEST(blame_recording, an_offset_that_was_applied_bridges_no_other) {
  for (const double applied_s : {-0.366, 17.95}) {
    calibration::CalibrationResult result;
    result.status = calibration::Status::Ok;
    result.set_observed(calibration::ParameterSet::all(), {});
    result.time_offset = {applied_s, 0.001, true};
    result.session_time_offset_s = {applied_s};
    blame_recording({{drive::Severity::Problem, "clock-far", std::string("drive"), {}}}, result, 18.0);
    EXPECT_EQ(result.status == calibration::Status::Inconsistent, applied_s < 0.0) << applied_s;
  }
}

}  // namespace
}  // namespace remount::pipeline
