// Methods that rest on the LiDAR's own odometry: over many drives, sensors that turn slowly and fast, one way and the
// other, their errors must be as large as the stated sigma says. One kind of drive takes some ten minutes;
// REMOUNT_DRIVES sets another number of drives than 40, and a filter picks kinds:
//   REMOUNT_DRIVES=10 build/headless/bin/long_tests --gtest_filter='*odometry_methods_sigma*/figure_eight_5_Hz_*'
#include <gtest/gtest.h>

#include <cmath>

#include "algorithms/core/parallel.h"
#include "model/methods/trajectory/trajectory_method.h"
#include "model/methods/vehicle_frame/vehicle_frame_method.h"
#include "model/pipeline/pipeline.h"
#include "model/simulator/road.h"
#include "model/simulator/simulator.h"
#include "tests/support/calibration_checks.h"
#include "tests/support/chi_square.h"
#include "tests/support/drive_count.h"

namespace remount::testing {
namespace {

struct KindOfDrive {
  const char* name;
  simulator::ScenarioKind scenario;
  int scan_rate_hz;
  bool clockwise;
};

/// Errors over sigma of both methods, in order of kParameters; not a number where not observed.
struct ErrorsOfDrive {
  std::array<double, 6> trajectory, vehicle_frame;
};

simulator::SimulationOptions odometry_drive(const KindOfDrive& kind, int seed) {
  simulator::SimulationOptions options;
  options.scenario = kind.scenario;
  options.scan_rate_hz = kind.scan_rate_hz;
  options.clockwise = kind.clockwise;
  options.seed = seed;
  options.beams = 24;
  options.azimuth_steps = 400;
  options.duration_s = 40.0;
  return options;
}

// Both methods on the poses of one odometry, which each would find for itself.
ErrorsOfDrive errors_of_drive(const simulator::SimulationOptions& options) {
  const simulator::SimulatedDrive drive = simulator::simulate_drive(options);
  pipeline::PipelineInput input;
  input.sessions = {std::make_shared<drive::Session>(drive.session)};
  input.nominal_ins_from_lidar = drive.ins_from_lidar;
  input.threads = 1;
  Progress progress;
  methods::TrajectoryFeed feed(input.settings, input.nominal_ins_from_lidar, input.threads);
  feed.begin(*input.sessions.front());
  feed.offer(*input.sessions.front(), true, options.duration_s, {}, progress);
  ErrorsOfDrive errors;
  errors.trajectory = normalised_errors(feed.finish(input.sessions, progress).answer.result, drive.ins_from_lidar);

  auto with_poses = std::make_shared<drive::Session>(drive.session);
  with_poses->scans = nullptr;
  for (const odometry::OdometryPose& pose : feed.odometry().front().poses)
    if (pose.aligned) with_poses->odometry_from_lidar.push_back({pose.stamp_ns, pose.odometry_from_lidar});
  input.sessions = {with_poses};
  const RigidTransform vehicle_from_lidar = simulator::vehicle_from_ins(options.scenario) * drive.ins_from_lidar;
  input.nominal_ins_from_lidar = vehicle_from_lidar;
  errors.vehicle_frame = normalised_errors(methods::run_vehicle_frame(input, progress).result, vehicle_from_lidar);
  return errors;
}

void expect_as_stated(const char* method, const std::vector<ErrorsOfDrive>& drives,
                      std::array<double, 6> ErrorsOfDrive::*errors_of_method) {
  for (std::size_t parameter = 0; parameter < 6; ++parameter) {
    double squares = 0.0, sum = 0.0, largest = 0.0, count = 0.0;
    for (const ErrorsOfDrive& drive : drives) {
      const double error = (drive.*errors_of_method)[parameter];
      if (!std::isfinite(error)) continue;
      squares += error * error;
      sum += error;
      largest = std::max(largest, std::abs(error));
      count += 1.0;
    }
    if (count == 0.0) continue;
    std::printf("  %-13s %-5s: %2.0f drives, chi-square %6.1f (at most %.1f), mean %+.2f, largest %.2f sigma\n", method,
                to_string(calibration::kParameters[parameter]).data(), count, squares,
                chi_square_quantile(count, kOnePercentAbove), sum / count, largest);
    EXPECT_LT(squares, chi_square_quantile(count, kOnePercentAbove))
        << method << ", " << to_string(calibration::kParameters[parameter]);
  }
}

class odometry_methods_sigma : public ::testing::TestWithParam<KindOfDrive> {};

TEST_P(odometry_methods_sigma, is_as_large_as_the_errors) {
  const KindOfDrive& kind = GetParam();
  std::vector<ErrorsOfDrive> drives(drive_count(40));
  parallel_for(drives.size(), 0,
               [&](std::size_t i) { drives[i] = errors_of_drive(odometry_drive(kind, 26000 + static_cast<int>(i))); });
  expect_as_stated("trajectory", drives, &ErrorsOfDrive::trajectory);
  expect_as_stated("vehicle-frame", drives, &ErrorsOfDrive::vehicle_frame);
}

std::vector<KindOfDrive> kinds_of_drives() {
  std::vector<KindOfDrive> kinds;
  for (const auto& [name, scenario] :
       {std::pair{"flat", simulator::ScenarioKind::Flat}, std::pair{"street", simulator::ScenarioKind::Street},
        std::pair{"hill", simulator::ScenarioKind::Hill},
        std::pair{"figure_eight", simulator::ScenarioKind::FigureEight}})
    for (const int rate_hz : {5, 10, 20})
      for (const bool clockwise : {true, false}) kinds.push_back({name, scenario, rate_hz, clockwise});
  return kinds;
}

INSTANTIATE_TEST_SUITE_P(drives, odometry_methods_sigma, ::testing::ValuesIn(kinds_of_drives()),
                         [](const ::testing::TestParamInfo<KindOfDrive>& kind) {
                           return std::string(kind.param.name) + "_" + std::to_string(kind.param.scan_rate_hz) +
                                  "_Hz_" + (kind.param.clockwise ? "clockwise" : "counterclockwise");
                         });

}  // namespace
}  // namespace remount::testing
