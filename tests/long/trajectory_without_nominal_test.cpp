// A hundred drives that the method `trajectory` solves from a cold start, as pairwise calibration does. Takes a quarter
// of an hour; REMOUNT_DRIVES sets another number of drives.
#include <gtest/gtest.h>

#include "algorithms/core/parallel.h"
#include "algorithms/messages/render.h"
#include "model/methods/trajectory/trajectory_method.h"
#include "model/pipeline/pipeline.h"
#include "model/simulator/simulator.h"
#include "tests/support/calibration_checks.h"
#include "tests/support/drive_count.h"

namespace remount::testing {
namespace {

simulator::SimulationOptions cold_drive(int seed) {
  simulator::SimulationOptions options;
  options.scenario = simulator::ScenarioKind::Flat;
  options.seed = seed;
  options.beams = 24;
  options.azimuth_steps = 512;
  options.scan_rate_hz = 5;
  options.duration_s = 40.0;
  options.ins_from_lidar =
      rigid_from_six({0.9, 0.25, 0.75, degrees_to_radians(1.7), degrees_to_radians(-1.1), degrees_to_radians(0.9)});
  return options;
}

TEST(trajectory_without_nominal, fails_on_none_of_a_hundred_drives) {
  std::vector<calibration::CalibrationResult> results(drive_count(100));
  parallel_for(results.size(), 0, [&](std::size_t i) {
    pipeline::PipelineInput input;
    input.sessions = {
        std::make_shared<drive::Session>(simulator::simulate_drive(cold_drive(static_cast<int>(i) + 1)).session)};
    input.threads = 1;
    Progress progress;
    results[i] = methods::run_trajectory_method(input, progress).result;
  });
  double largest = 0.0;
  for (std::size_t i = 0; i < results.size(); ++i) {
    EXPECT_TRUE(calibration::is_usable(results[i])) << "seed " << i + 1 << ": " << english(results[i].message);
    for (const double error : normalised_errors(results[i], cold_drive(1).ins_from_lidar)) {
      if (!std::isfinite(error)) continue;
      largest = std::max(largest, std::abs(error));
      EXPECT_LT(std::abs(error), 4.0) << "seed " << i + 1;
    }
  }
  std::printf("  %zu drives, the largest error %.2f sigma\n", results.size(), largest);
}

}  // namespace
}  // namespace remount::testing
