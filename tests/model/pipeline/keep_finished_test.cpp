#include "model/pipeline/keep_finished.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "algorithms/messages/render.h"
#include "messages/stages.h"
#include "model/results/exporters/exporter.h"
#include "model/results/preliminary.h"
#include "model/results/result_file.h"
#include "model/simulator/simulator.h"
#include "tests/support/calibration_checks.h"
#include "tests/support/kept_scans.h"

namespace remount::pipeline {
namespace {

struct Cancelled {
  simulator::SimulatedDrive drive;
  PipelineInput input;
  PipelineOutput output;
};

/// A calibration that is cancelled while it registers pairs, once the share of them is aligned.
Cancelled cancelled_at(double share) {
  simulator::SimulationOptions options;
  options.beams = 24;
  options.azimuth_steps = 400;
  options.duration_s = 9.0;
  Cancelled run{testing::simulate_drive(options), {}, {}};
  run.input.sessions.push_back(std::make_shared<drive::Session>(run.drive.session));
  run.input.nominal_ins_from_lidar = run.drive.ins_from_lidar;
  std::stop_source stop;
  Progress progress(stop.get_token(), [&](const ProgressUpdate& update) {
    if (update.stage == say::stage_registering_pairs &&
        static_cast<double>(update.done) >= share * static_cast<double>(update.total))
      stop.request_stop();
  });
  run.output = run_pipeline(run.input, progress);
  return run;
}

std::size_t with_reason(const PipelineOutput& output, const std::string& reason) {
  return static_cast<std::size_t>(
      std::count_if(output.pairs.begin(), output.pairs.end(),
                    [&](const motion::Pair& pair) { return english(pair.reason) == reason; }));
}

TEST(keep_finished, what_was_aligned_is_solved_and_the_rest_says_why_it_is_not) {
  Cancelled run = cancelled_at(0.5);
  ASSERT_EQ(run.output.result.status, calibration::Status::Cancelled);
  const std::size_t pairs = run.output.pairs.size(), kept = keep_finished(run.input, run.output);
  EXPECT_GE(kept, pairs / 3);
  EXPECT_LT(kept, 2 * pairs / 3);
  EXPECT_GE(with_reason(run.output, "not aligned: the calibration was cancelled"), pairs / 3);
  EXPECT_EQ(run.output.findings.back().code, "cancelled");
  Progress progress;
  solve_again(run.input, run.output, progress);
  EXPECT_TRUE(results::is_preliminary(run.output.result)) << english(run.output.result.message);
  EXPECT_EQ(run.output.result.status, calibration::Status::Degenerate)
      << "whoever looks at the status alone is to look again";
  EXPECT_EQ(results::export_warnings(run.output.result).at(0), run.output.result.message);
  const testing::CalibrationError error = testing::error_of(run.output.result, run.drive.ins_from_lidar);
  std::printf("  %zu of %zu pairs: %.4f deg, %.1f %.1f %.1f mm\n", kept, pairs, error.rotation_deg, 1e3 * error.x_m,
              1e3 * error.y_m, 1e3 * error.z_m);
  testing::expect_within_sigma(run.output.result, run.drive.ins_from_lidar, 4.0);
}

TEST(keep_finished, nothing_is_kept_of_what_had_aligned_nothing) {
  Cancelled run = cancelled_at(0.5);
  for (motion::Pair& pair : run.output.pairs) pair.registration = {};
  const std::size_t findings = run.output.findings.size();
  EXPECT_EQ(keep_finished(run.input, run.output), 0U);
  EXPECT_EQ(run.output.findings.size(), findings);
  Cancelled with_clock = cancelled_at(0.5);
  with_clock.input.settings.solve.apply_time_offset = calibration::ClockOffsetUse::Yes;
  EXPECT_EQ(keep_finished(with_clock.input, with_clock.output), 0U) << "its clocks are not known yet";
}

}  // namespace
}  // namespace remount::pipeline
