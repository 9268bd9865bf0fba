// Wheels whose slip lasts for seconds: y of the sensor rests on the way in turns, and a drive has few of them.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>

#include "algorithms/core/parallel.h"
#include "model/methods/vehicle_frame/vehicle_frame_method.h"
#include "model/pipeline/pipeline.h"
#include "model/simulator/road.h"
#include "model/simulator/simulator.h"
#include "tests/support/calibration_checks.h"
#include "tests/support/draws.h"
#include "tests/support/noisy_odometry.h"

namespace remount::methods {
namespace {

std::array<double, 6> errors_in_sigma(simulator::ScenarioKind scenario, int seed) {
  simulator::SimulationOptions options;
  options.scenario = scenario;
  options.seed = seed;
  options.duration_s = 60.0;
  options.wheels.lasting_slip = 0.02;
  const simulator::SimulatedDrive drive = simulator::simulate_drive(options);
  auto session = std::make_shared<drive::Session>(drive.session);
  session->scans = nullptr;
  session->odometry_from_lidar = testing::noisy_odometry(drive, 0.003, 2e-4, static_cast<std::uint64_t>(seed));
  pipeline::PipelineInput input;
  input.sessions = {session};
  input.threads = 1;
  Progress progress;
  return testing::normalised_errors(run_vehicle_frame(input, progress).result,
                                    simulator::vehicle_from_ins(scenario) * drive.ins_from_lidar);
}

// A slip of 2% that lasts ten seconds is there six times in a drive of a minute: its sigma is itself known to a third.
TEST(vehicle_frame_with_lasting_slip, errs_by_little_more_than_it_says) {
  for (const auto& [name, scenario] :
       {std::pair{"street", simulator::ScenarioKind::Street}, std::pair{"hill", simulator::ScenarioKind::Hill},
        std::pair{"figure of eight", simulator::ScenarioKind::FigureEight}}) {
    std::vector<std::array<double, 6>> drives(testing::draws_all() ? 16 : 8);
    parallel_for(drives.size(), 0,
                 [&, of = scenario](std::size_t i) { drives[i] = errors_in_sigma(of, 41300 + static_cast<int>(i)); });
    for (std::size_t parameter = 0; parameter < 6; ++parameter) {
      double squares = 0.0, largest = 0.0;
      int count = 0;
      for (const auto& errors : drives)
        if (std::isfinite(errors[parameter])) {
          squares += errors[parameter] * errors[parameter], ++count;
          largest = std::max(largest, std::abs(errors[parameter]));
        }
      if (count == 0) continue;
      std::printf("  %-15s %-5s: %2d drives, chi2 / n = %.2f, largest %.1f sigma\n", name,
                  to_string(calibration::kParameters[parameter]).data(), count, squares / count, largest);
      EXPECT_LT(squares / count, 2.2) << name << ", " << to_string(calibration::kParameters[parameter]);
      EXPECT_LT(largest, 5.0) << name << ", " << to_string(calibration::kParameters[parameter]);
    }
  }
}

}  // namespace
}  // namespace remount::methods
