// Memory is bounded by the cache setting, not by the length of a drive.
#include <gtest/gtest.h>

#include <chrono>

#include "algorithms/messages/render.h"
#include "model/simulator/simulator.h"
#include "tests/support/calibration_checks.h"
#include "tests/support/peak_memory.h"

namespace remount::testing {
namespace {

// Every scan is a keyframe: ten thousand scans, thirty thousand registrations.
TEST(ten_thousand_scans, calibrate_within_two_gigabytes) {
  simulator::SimulationOptions options;
  options.duration_s = 1000.0;
  options.beams = 16;
  options.azimuth_steps = 180;
  options.max_range_m = 50.0;
  options.ins_rate_hz = 50.0;
  const simulator::SimulatedDrive drive = simulator::simulate_drive(options);
  ASSERT_GE(drive.session.scans->size(), 10000U);
  pipeline::PipelineInput input;
  input.sessions.push_back(std::make_shared<drive::Session>(drive.session));
  input.nominal_ins_from_lidar = drive.ins_from_lidar;
  input.settings.run.cache_mb = 256;
  input.settings.keyframes.mode = motion::KeyframeMode::Time;
  input.settings.keyframes.interval_s = 0.1;
  input.settings.keyframes.maximum = 10000;
  input.settings.pairing.max_partners = 3;
  input.settings.pairing.choice = motion::PairChoice::All;
  Progress progress;
  const auto start = std::chrono::steady_clock::now();
  const pipeline::PipelineOutput output = pipeline::run_pipeline(input, progress);
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  const CalibrationError error = error_of(output.result, drive.ins_from_lidar);
  std::printf("  %zu keyframes, %zu pairs, %.0f s, peak %.0f MB\n", output.keyframes.size(), output.pairs.size(),
              seconds, peak_mb());
  EXPECT_GE(output.keyframes.size(), 9990U);
  EXPECT_LT(peak_mb(), 2048.0);
  EXPECT_EQ(output.result.status, calibration::Status::Ok) << english(output.result.message);
  EXPECT_LE(error.rotation_deg, 0.02);
  EXPECT_LE(std::hypot(error.x_m, error.y_m), 0.01);
}

}  // namespace
}  // namespace remount::testing
