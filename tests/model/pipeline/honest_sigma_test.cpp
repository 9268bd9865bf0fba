// Thirty simulated drives: errors must be as large as the stated sigma says, neither larger nor smaller.
#include <gtest/gtest.h>

#include "algorithms/core/parallel.h"
#include "model/simulator/simulator.h"
#include "tests/support/calibration_checks.h"
#include "tests/support/sanitized.h"

namespace remount {
namespace {

void expect_honest_sigma(int beams, int first_seed) {
  constexpr std::size_t kDrives = kSanitized ? 6 : 30;
  std::vector<std::array<double, 6>> normalised(kDrives);
  parallel_for(kDrives, 0, [&](std::size_t i) {
    SimulationOptions options;
    options.seed = first_seed + static_cast<int>(i);
    options.beams = beams;
    options.azimuth_steps = 400;
    options.duration_s = 9.0;
    const SimulatedDrive drive = simulate_drive(options);
    PipelineInput input;
    input.sessions.push_back(std::make_shared<Session>(drive.session));
    input.nominal_ins_from_lidar = drive.ins_from_lidar;
    input.settings.pairing.max_partners = 4;
    input.threads = 1;
    Progress progress;
    normalised[i] = normalised_errors(run_pipeline(input, progress).result, drive.ins_from_lidar);
  });
  // 0.5% and 99.5% of chi-square with as many degrees of freedom.
  constexpr double kLower = kSanitized ? 0.676 : 13.79, kUpper = kSanitized ? 18.55 : 53.67;
  for (std::size_t parameter = 0; parameter < 6; ++parameter) {
    double sum = 0.0, mean = 0.0;
    std::size_t count = 0;
    for (const auto& drive : normalised)
      if (std::isfinite(drive[parameter])) {
        sum += drive[parameter] * drive[parameter];
        mean += drive[parameter] / kDrives;
        ++count;
      }
    std::printf("  %s: %zu drives, mean %.2f, chi-square %.1f\n", kParameterNames[parameter].data(), count, mean, sum);
    EXPECT_EQ(count, kDrives) << kParameterNames[parameter];
    EXPECT_LT(sum, kUpper) << kParameterNames[parameter] << ": sigma is too small";
    EXPECT_GT(sum, kLower) << kParameterNames[parameter] << ": sigma is too large";
  }
}

TEST(sigma_of_thirty_drives, passes_a_chi_square_test_for_every_observed_parameter) { expect_honest_sigma(64, 100); }

TEST(sigma_of_thirty_drives, passes_it_with_a_sparse_sensor) { expect_honest_sigma(24, 400); }

}  // namespace
}  // namespace remount
