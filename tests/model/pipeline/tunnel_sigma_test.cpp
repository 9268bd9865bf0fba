// Between smooth walls every registration is off the same way, and the bend is the same throughout: what no residual
// shows must be part of sigma.
#include <gtest/gtest.h>

#include "algorithms/core/parallel.h"
#include "model/simulator/simulator.h"
#include "tests/support/calibration_checks.h"
#include "tests/support/kept_scans.h"

namespace remount::pipeline {
namespace {

TEST(tunnel_sigma, holds_where_registrations_are_wrong_alike) {
  constexpr std::size_t kDrives = 3;
  std::vector<std::array<double, 6>> normalised(kDrives);
  parallel_for(kDrives, 0, [&](std::size_t i) {
    simulator::SimulationOptions options;
    options.scenario = simulator::ScenarioKind::Tunnel;
    options.seed = 4 + static_cast<int>(i);
    options.beams = 32;
    options.azimuth_steps = 800;
    options.duration_s = 20.0;
    const simulator::SimulatedDrive drive = testing::simulate_drive(options);
    PipelineInput input;
    input.sessions.push_back(std::make_shared<drive::Session>(drive.session));
    input.settings.pairing.max_partners = 4;
    input.settings.run.map_check = false;
    input.threads = 1;
    Progress progress;
    normalised[i] = testing::normalised_errors(run_pipeline(input, progress).result, drive.ins_from_lidar);
  });
  for (const std::size_t parameter : {1U, 4U, 5U}) {
    double sum = 0.0, count = 0.0;
    std::printf("  %s:", to_string(calibration::kParameters[parameter]).data());
    for (const auto& drive : normalised)
      if (std::isfinite(drive[parameter])) {
        std::printf(" %.2f", drive[parameter]);
        sum += drive[parameter] * drive[parameter];
        ++count;
      }
    std::printf(" sigma\n");
    EXPECT_LT(sum, 3.8 * kDrives) << to_string(calibration::kParameters[parameter])
                                  << ": sigma is too small";  // chi-square of three at 1%
    EXPECT_EQ(count, kDrives) << to_string(calibration::kParameters[parameter]) << " is told by each of these drives";
  }
}

}  // namespace
}  // namespace remount::pipeline
