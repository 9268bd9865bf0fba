// A hundred drives of each kind: errors must be as large as the stated sigma says, neither larger nor smaller, and what
// is not observed must carry none. Runs for an hour; REMOUNT_DRIVES sets another number of drives.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <random>

#include "algorithms/core/parallel.h"
#include "model/simulator/simulator.h"
#include "tests/support/calibration_checks.h"
#include "tests/support/chi_square.h"
#include "tests/support/drive_count.h"

namespace remount::testing {
namespace {

simulator::SimulationOptions drive_options(simulator::ScenarioKind scenario, int seed) {
  simulator::SimulationOptions options;
  options.scenario = scenario;
  options.seed = seed;
  options.beams = 24;
  options.azimuth_steps = 400;
  options.duration_s = 9.0;
  return options;
}

struct Drives {
  std::vector<simulator::SimulationOptions> sessions;
  Vector6d nominal_error = Vector6d::Zero();  ///< of the nominal, under `perturb`
};

// What the solver takes a nominal to be good for: where a direction is not observed, its error is that of the nominal.
Vector6d error_of_a_nominal(int seed) {
  std::mt19937_64 random(static_cast<std::uint64_t>(seed));
  std::normal_distribution<double> normal;
  Vector6d error;
  for (int i = 0; i < 6; ++i) error[i] = (i < 3 ? 2.0 : 0.1) * normal(random);
  return error;
}

calibration::CalibrationResult calibrate(const Drives& drives) {
  pipeline::PipelineInput input;
  for (const simulator::SimulationOptions& options : drives.sessions) {
    simulator::SimulatedDrive drive = simulator::simulate_drive(options);
    drive.session.ins_attitude_bias_sigma_rad = 0.0;  // an INS does not know what is wrong with it
    input.sessions.push_back(std::make_shared<drive::Session>(drive.session));
  }
  input.nominal_ins_from_lidar = perturb(drives.sessions.front().ins_from_lidar, drives.nominal_error);
  // The nominal may lie anywhere.
  input.settings.range.x_min_m = input.settings.range.y_min_m = input.settings.range.z_min_m = -20.0;
  input.settings.range.x_max_m = input.settings.range.y_max_m = input.settings.range.z_max_m = 20.0;
  input.settings.pairing.max_partners = 4;
  input.settings.run.map_check = false;
  input.threads = 1;
  Progress progress;
  return pipeline::run_pipeline(input, progress).result;
}

/// @param observed which parameters every drive must show, which none may
void expect_honest(const std::function<Drives(int drive)>& drives_of, calibration::ParameterSet observed) {
  const std::size_t drives = drive_count(100);
  std::vector<std::array<double, 6>> normalised(drives), sigmas(drives);
  parallel_for(drives, 0, [&](std::size_t i) {
    const Drives one = drives_of(static_cast<int>(i));
    const calibration::CalibrationResult result = calibrate(one);
    normalised[i] = normalised_errors(result, one.sessions.front().ins_from_lidar);
    for (std::size_t parameter = 0; parameter < 6; ++parameter)
      sigmas[i][parameter] = result.estimate(calibration::kParameters[parameter]).sigma.value_or(0.0);
  });
  for (std::size_t parameter = 0; parameter < 6; ++parameter) {
    double sum = 0.0, mean = 0.0, largest = 0.0, errors2 = 0.0, sigmas2 = 0.0;
    std::size_t count = 0;
    for (std::size_t i = 0; i < drives; ++i) {
      const double error = normalised[i][parameter], sigma = sigmas[i][parameter];
      if (!std::isfinite(error)) continue;
      sum += error * error;
      mean += error / static_cast<double>(drives);
      largest = std::max(largest, std::abs(error));
      errors2 += error * error * sigma * sigma;
      sigmas2 += sigma * sigma;
      ++count;
    }
    const auto freedom = static_cast<double>(count);
    const double lower = chi_square_quantile(freedom, -kOnePercentOutside),
                 upper = chi_square_quantile(freedom, kOnePercentOutside);
    const double unit = parameter < 3 ? 1e3 : radians_to_degrees(1e3), root = unit / std::sqrt(std::max(1.0, freedom));
    std::printf(
        "  %-5s: %3zu of %zu drives, chi-square %.1f (%.1f to %.1f), mean %+.2f, largest %.2f sigma; rms error %.2f, "
        "rms sigma %.2f %s\n",
        to_string(calibration::kParameters[parameter]).data(), count, drives, sum, lower, upper, mean, largest,
        root * std::sqrt(errors2), root * std::sqrt(sigmas2), parameter < 3 ? "mm" : "mdeg");
    if (!observed.contains(calibration::kParameters[parameter])) {
      EXPECT_EQ(count, 0U) << to_string(calibration::kParameters[parameter]) << " cannot be observed and has a sigma";
      continue;
    }
    EXPECT_EQ(count, drives) << to_string(calibration::kParameters[parameter]);
    EXPECT_LT(sum, upper) << to_string(calibration::kParameters[parameter]) << ": sigma is too small";
    EXPECT_GT(sum, lower) << to_string(calibration::kParameters[parameter]) << ": sigma is too large";
  }
}

TEST(sigma_of_a_hundred_drives, undulating) {
  expect_honest([](int i) { return Drives{{drive_options(simulator::ScenarioKind::Street, 20000 + i)}}; },
                calibration::ParameterSet::all());
}

TEST(sigma_of_a_hundred_drives, flat) {
  expect_honest([](int i) { return Drives{{drive_options(simulator::ScenarioKind::Flat, 21000 + i)}}; },
                ~calibration::ParameterSet{calibration::Parameter::Z});
}

TEST(sigma_of_a_hundred_drives, straight) {
  expect_honest(
      [](int i) {
        return Drives{{drive_options(simulator::ScenarioKind::Straight, 22000 + i)}, error_of_a_nominal(i)};
      },
      {calibration::Parameter::Yaw, calibration::Parameter::Pitch});
}

TEST(sigma_of_a_hundred_drives, figure_of_eight) {
  expect_honest([](int i) { return Drives{{drive_options(simulator::ScenarioKind::FigureEight, 23000 + i)}}; },
                calibration::ParameterSet::all());
}

// Three drives, one of them with an INS that is turned by some tenths of a degree and does not know.
TEST(sigma_of_a_hundred_drives, one_outlier_session) {
  expect_honest(
      [](int i) {
        Drives drives;
        for (int s = 0; s < 3; ++s)
          drives.sessions.push_back(drive_options(simulator::ScenarioKind::Street, 24000 + 10 * i + s));
        drives.sessions[2].ins_attitude_bias_deg = 0.3;
        return drives;
      },
      calibration::ParameterSet::all());
}

TEST(sigma_of_a_hundred_drives, drifting_ins) {
  expect_honest(
      [](int i) {
        simulator::SimulationOptions options = drive_options(simulator::ScenarioKind::Street, 25000 + i);
        options.ins_position_drift_m = 0.01;
        options.ins_attitude_drift_deg = 0.01;
        return Drives{{options}};
      },
      calibration::ParameterSet::all());
}

}  // namespace
}  // namespace remount::testing
