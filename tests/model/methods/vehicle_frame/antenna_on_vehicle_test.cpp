// An antenna on a car whose IMU is fitted a degree askew, as by hand: roads that lean and climb move what is 1.7 m
// high.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

#include "algorithms/core/parallel.h"
#include "model/methods/vehicle_frame/vehicle_frame_method.h"
#include "model/pipeline/pipeline.h"
#include "model/simulator/simulator.h"

namespace remount::methods {
namespace {

struct AntennaErrors {
  double x = NAN, y = NAN;  // in sigmas
};

AntennaErrors antenna_errors_in_sigma(simulator::ScenarioKind scenario, int seed) {
  simulator::SimulationOptions options;
  options.scenario = scenario;
  options.seed = seed;
  options.duration_s = 60.0;
  options.beams = 1;
  options.azimuth_steps = 16;
  const simulator::SimulatedDrive drive = simulator::simulate_drive(options);
  auto session = std::make_shared<drive::Session>(drive.session);
  session->scans = nullptr;
  session->ins.clear();
  session->world_from_ins.clear();
  session->odometry_from_lidar.clear();
  pipeline::PipelineInput input;
  input.sessions = {session};
  input.threads = 1;
  Progress progress;
  const calibration::CalibrationResult result = run_vehicle_frame(input, progress).result;
  const Eigen::Vector3d error = result.mounting.reference_from_sensor.translation() -
                                drive.sensors.vehicle_from_ins * drive.sensors.antenna_in_ins_m;
  return {error.x() / result.estimate(calibration::Parameter::X).sigma.value_or(NAN),
          error.y() / result.estimate(calibration::Parameter::Y).sigma.value_or(NAN)};
}

TEST(antenna_on_vehicle, errs_as_its_sigmas_say_on_roads_that_lean) {
  constexpr double kMost = 1.79;  // of chi-square over its count: the 1% limit of 24 drives
  for (const auto& [name, scenario] :
       {std::pair{"flat", simulator::ScenarioKind::Flat}, std::pair{"street", simulator::ScenarioKind::Street},
        std::pair{"figure of eight", simulator::ScenarioKind::FigureEight},
        std::pair{"hill", simulator::ScenarioKind::Hill}}) {
    std::array<AntennaErrors, 24> drives;
    parallel_for(drives.size(), 0, [&, of = scenario](std::size_t i) {
      drives[i] = antenna_errors_in_sigma(of, 61000 + static_cast<int>(i));
    });
    AntennaErrors chi2{0.0, 0.0}, largest{0.0, 0.0};
    for (const AntennaErrors& one : drives) {
      ASSERT_TRUE(std::isfinite(one.x) && std::isfinite(one.y)) << name;
      chi2 = {chi2.x + one.x * one.x / drives.size(), chi2.y + one.y * one.y / drives.size()};
      largest = {std::max(largest.x, std::abs(one.x)), std::max(largest.y, std::abs(one.y))};
    }
    std::printf("  %-15s chi2 / n: x %.2f, y %.2f; largest %.1f, %.1f sigma\n", name, chi2.x, chi2.y, largest.x,
                largest.y);
    EXPECT_LT(chi2.x, kMost) << name;
    EXPECT_LT(chi2.y, kMost) << name;
    EXPECT_LT(std::max(largest.x, largest.y), 4.0) << name;
  }
}

}  // namespace
}  // namespace remount::methods
