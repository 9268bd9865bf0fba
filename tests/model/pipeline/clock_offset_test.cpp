// Clocks of LiDAR and INS that differ, and what only looks as if they did.
#include <gtest/gtest.h>

#include <algorithm>

#include "algorithms/messages/render.h"
#include "model/formats/ins/samples_between_fixes.h"
#include "model/simulator/simulator.h"
#include "tests/support/calibration_checks.h"
#include "tests/support/draws.h"
#include "tests/support/kept_scans.h"

namespace remount::pipeline {
namespace {

simulator::SimulationOptions eight(double lidar_clock_offset_s, int seed = 1) {
  simulator::SimulationOptions options;
  options.scenario = simulator::ScenarioKind::FigureEight;
  options.beams = 24;
  options.azimuth_steps = 512;
  options.seed = seed;
  options.lidar_clock_offset_s = lidar_clock_offset_s;
  return options;
}

struct ClockRun {
  PipelineInput input;
  PipelineOutput output;
  RigidTransform truth;
};

ClockRun calibrate_clocks(const std::vector<simulator::SimulatedDrive>& drives,
                          calibration::ClockOffsetUse use = calibration::ClockOffsetUse::Auto) {
  ClockRun run;
  for (const simulator::SimulatedDrive& drive : drives)
    run.input.sessions.push_back(std::make_shared<drive::Session>(drive.session));
  run.input.settings.solve.apply_time_offset = use;
  run.input.settings.run.map_check = false;
  run.truth = drives.front().ins_from_lidar;
  Progress progress;
  run.output = run_pipeline(run.input, progress);
  return run;
}

std::vector<drive::Finding> clock_findings(const PipelineOutput& output) {
  std::vector<drive::Finding> found;
  std::copy_if(output.findings.begin(), output.findings.end(), std::back_inserter(found),
               [](const drive::Finding& finding) { return finding.code == "clock-offset"; });
  return found;
}

TEST(clock_offset, of_30_ms_is_taken_out_without_being_asked_for_and_left_in_by_one_setting) {
  ClockRun run = calibrate_clocks({testing::simulate_drive(eight(0.03))});
  const calibration::CalibrationResult whole = run.output.result;
  const testing::CalibrationError error = testing::error_of(whole, run.truth);
  EXPECT_EQ(whole.status, calibration::Status::Ok) << english(whole.message);
  EXPECT_LT(std::abs(error.x_m), 0.01);
  EXPECT_LT(std::abs(error.y_m), 0.01);
  EXPECT_TRUE(whole.known[calibration::Parameter::Z].observed);
  testing::expect_within_sigma(whole, run.truth, 4.0);
  EXPECT_TRUE(whole.time_offset.applied);
  EXPECT_NEAR(whole.time_offset.offset_s, 0.03, 1e-3);
  ASSERT_EQ(whole.session_time_offset_s.size(), 1U);
  EXPECT_NEAR(whole.session_time_offset_s[0], 0.03, 4.0 * whole.session_time_offset_sigma_s[0] + 1e-4);
  const std::vector<drive::Finding> said = clock_findings(run.output);
  ASSERT_EQ(said.size(), 1U);
  EXPECT_EQ(said[0].severity, drive::Severity::Note);
  EXPECT_TRUE(english(said[0].explanation).ends_with("X is solved with that taken out."))
      << english(said[0].explanation);

  // In the window, from the pairs that are there.
  Progress progress;
  run.input.settings.solve.apply_time_offset = calibration::ClockOffsetUse::No;
  ASSERT_TRUE(solve_again(run.input, run.output, progress));
  const calibration::CalibrationResult& without = run.output.result;
  EXPECT_FALSE(without.time_offset.applied);
  EXPECT_NEAR(without.time_offset.offset_s, 0.03, 2e-3) << "it is still known";
  EXPECT_TRUE(run.output.clock_bias);
  EXPECT_GT((without.mounting.ins_from_lidar().translation() - run.truth.translation()).norm(), 0.03);
  testing::expect_within_sigma(without, run.truth, 4.0);
  ASSERT_EQ(clock_findings(run.output).size(), 1U);
  EXPECT_EQ(clock_findings(run.output)[0].severity, drive::Severity::Warning);
  run.input.settings.solve.apply_time_offset = calibration::ClockOffsetUse::Auto;
  ASSERT_TRUE(solve_again(run.input, run.output, progress));
  EXPECT_TRUE(run.output.result.time_offset.applied);
  EXPECT_LT(
      (run.output.result.mounting.reference_from_sensor.translation() - whole.mounting.ins_from_lidar().translation())
          .norm(),
      0.01);
}

TEST(clock_offset, is_that_of_each_session) {
  ONLY_IN_LONG_TESTS();
  const ClockRun run =
      calibrate_clocks({testing::simulate_drive(eight(-0.03, 1)), testing::simulate_drive(eight(0.0, 2))});
  const calibration::CalibrationResult& result = run.output.result;
  testing::error_of(result, run.truth);
  testing::expect_within_sigma(result, run.truth, 4.0);
  EXPECT_TRUE(result.time_offset.applied);
  ASSERT_EQ(result.session_time_offset_s.size(), 2U);
  EXPECT_NEAR(result.session_time_offset_s[0], -0.03, 1e-3);
  EXPECT_NEAR(result.session_time_offset_s[1], 0.0, 1e-3);
  const std::vector<drive::Finding> said = clock_findings(run.output);
  ASSERT_EQ(said.size(), 1U) << "the clocks of the second agree";
  EXPECT_TRUE(english(said[0].explanation).find("late by 30.") != std::string::npos ||
              english(said[0].explanation).find("late by 29.") != std::string::npos)
      << english(said[0].explanation);
}

/// Too small to be spoken of, and ten times as large as X could bear without a word.
TEST(clock_offset, of_less_than_2_ms_is_in_the_sigmas) {
  for (const double offset_s : testing::some_of({0.0018, -0.0006})) {
    simulator::SimulationOptions options = eight(offset_s, 6);
    options.scenario = simulator::ScenarioKind::Street;
    options.speed_mps = 9.0;
    options.duration_s = 15.0;
    const ClockRun run = calibrate_clocks({testing::simulate_drive(options)});
    testing::error_of(run.output.result, run.truth);
    EXPECT_NEAR(run.output.result.time_offset.offset_s, offset_s, 2e-4);
    EXPECT_FALSE(run.output.result.time_offset.applied);
    EXPECT_TRUE(clock_findings(run.output).empty());
    testing::expect_within_sigma(run.output.result, run.truth, 3.5);
  }
}

TEST(clock_offset, is_taken_out_also_where_x_then_lies_outside_the_search_range) {
  const simulator::SimulatedDrive drive = testing::simulate_drive(eight(0.02, 7));
  const double x_m = drive.ins_from_lidar.translation().x();
  PipelineInput input;
  input.sessions.push_back(std::make_shared<drive::Session>(drive.session));
  input.settings.run.map_check = false;
  input.settings.range.x_min_m = x_m + 0.02;  // where X lies by the clocks as they are
  Progress progress;
  const calibration::CalibrationResult result = run_pipeline(input, progress).result;
  EXPECT_EQ(result.status, calibration::Status::OutOfRange) << english(result.message);
  EXPECT_NEAR(result.mounting.reference_from_sensor.translation().x(), x_m, 0.01);
  EXPECT_NEAR(result.time_offset.offset_s, 0.02, 1e-3);
}

/// The INS of a drive with a fix every second only.
void slow_down_fixes(bool attitudes_stay, drive::Session& session) {
  std::vector<motion::InsSample> at_fixes;
  std::vector<formats::StampedAttitude> attitudes;
  for (std::size_t i = 0; i < session.ins.size(); ++i) {
    const motion::InsSample& sample = session.ins[i];
    if (i % 100 == 0) at_fixes.push_back(sample);
    if (i % 2 == 0) attitudes.push_back({sample.stamp_ns, sample.enu_from_ins, sample.sigma.attitude_rad});
  }
  if (!attitudes_stay) {
    session.ins = at_fixes;
    return;
  }
  formats::SamplesBetweenFixes whole = formats::samples_between_fixes(at_fixes, attitudes);
  session.ins = std::move(whole.ins);
  session.ins_fix_stamps_ns = std::move(whole.fix_stamps_ns);
}

TEST(clock_offset, is_not_made_of_what_lies_between_slow_fixes) {
  ONLY_IN_LONG_TESTS();
  for (const bool attitudes_stay : {true, false})
    for (const int seed : testing::some_of({3, 4})) {
      simulator::SimulationOptions options = eight(0.0, seed);
      options.duration_s = 25.0;
      simulator::SimulatedDrive drive = testing::simulate_drive(options);
      slow_down_fixes(attitudes_stay, drive.session);
      const ClockRun run = calibrate_clocks({drive});
      const calibration::CalibrationResult& result = run.output.result;
      std::printf("  attitudes %s: offset %.1f ms (%.1f)\n", attitudes_stay ? "at 50 Hz" : "at 1 Hz",
                  1e3 * result.time_offset.offset_s, 1e3 * result.time_offset.sigma_s);
      testing::error_of(result, run.truth);
      EXPECT_FALSE(result.time_offset.applied);
      EXPECT_TRUE(clock_findings(run.output).empty());
      testing::expect_within_sigma(result, run.truth, 4.0);
      if (attitudes_stay) {
        EXPECT_TRUE(result.known[calibration::Parameter::Yaw].observed) << "they show how the vehicle turned";
      }
    }
}

/// Turns that begin and end between two samples are no straight turns.
TEST(clock_offset, is_not_made_of_what_lies_between_five_samples_a_second) {
  for (const int seed : testing::some_of({23, 74})) {
    simulator::SimulationOptions options = eight(0.0, seed);
    options.scenario = simulator::ScenarioKind::Street;
    options.ins_rate_hz = 5.0;
    options.duration_s = 18.0;
    const ClockRun run = calibrate_clocks({testing::simulate_drive(options)});
    testing::error_of(run.output.result, run.truth);
    EXPECT_TRUE(clock_findings(run.output).empty());
    testing::expect_within_sigma(run.output.result, run.truth, 3.5);
  }
}

TEST(clock_offset, is_still_found_between_slow_fixes_where_attitudes_show_it) {
  simulator::SimulationOptions options = eight(0.06, 5);
  options.duration_s = 25.0;
  simulator::SimulatedDrive drive = testing::simulate_drive(options);
  slow_down_fixes(true, drive.session);
  const ClockRun run = calibrate_clocks({drive});
  testing::error_of(run.output.result, run.truth);
  EXPECT_NEAR(run.output.result.time_offset.offset_s, 0.06, 0.01);
  EXPECT_TRUE(run.output.result.time_offset.applied);
  testing::expect_within_sigma(run.output.result, run.truth, 4.0);
}

}  // namespace
}  // namespace remount::pipeline
