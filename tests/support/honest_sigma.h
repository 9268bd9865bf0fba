// Simulated drives whose errors must be as large as the stated sigma says, neither larger nor smaller.
#pragma once

#include <gtest/gtest.h>

#include "algorithms/core/parallel.h"
#include "model/simulator/simulator.h"
#include "tests/support/calibration_checks.h"
#include "tests/support/chi_square.h"
#include "tests/support/kept_scans.h"

namespace remount::testing {

/// Drives of `beams`, from a seed on.
inline void expect_honest_sigma(int beams, int first_seed, std::size_t drives) {
  std::vector<std::array<double, 6>> normalised(drives);
  parallel_for(drives, 0, [&](std::size_t i) {
    simulator::SimulationOptions options;
    options.seed = first_seed + static_cast<int>(i);
    options.beams = beams;
    options.azimuth_steps = 400;
    options.duration_s = 9.0;
    const simulator::SimulatedDrive drive = testing::simulate_drive(options);
    pipeline::PipelineInput input;
    input.sessions.push_back(std::make_shared<drive::Session>(drive.session));
    input.nominal_ins_from_lidar = drive.ins_from_lidar;
    input.settings.pairing.max_partners = 4;
    input.settings.run.map_check = false;
    input.threads = 1;
    Progress progress;
    normalised[i] = normalised_errors(pipeline::run_pipeline(input, progress).result, drive.ins_from_lidar);
  });
  const double lower = chi_square_quantile(static_cast<double>(drives), -kOnePercentOutside),
               upper = chi_square_quantile(static_cast<double>(drives), kOnePercentOutside);
  for (std::size_t parameter = 0; parameter < 6; ++parameter) {
    double sum = 0.0, mean = 0.0;
    std::size_t count = 0;
    for (const auto& drive : normalised)
      if (std::isfinite(drive[parameter])) {
        sum += drive[parameter] * drive[parameter];
        mean += drive[parameter] / static_cast<double>(drives);
        ++count;
      }
    std::printf("  %s: %zu drives, mean %.2f, chi-square %.1f\n", to_string(calibration::kParameters[parameter]).data(),
                count, mean, sum);
    EXPECT_EQ(count, drives) << to_string(calibration::kParameters[parameter]);
    EXPECT_LT(sum, upper) << to_string(calibration::kParameters[parameter]) << ": sigma is too small";
    EXPECT_GT(sum, lower) << to_string(calibration::kParameters[parameter]) << ": sigma is too large";
  }
}

}  // namespace remount::testing
