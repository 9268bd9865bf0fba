// Three recordings of a simulated excavator and the method on them.
#pragma once

#include "algorithms/messages/render.h"
#include "model/methods/slew/slew_method.h"
#include "model/pipeline/pipeline.h"
#include "model/simulator/drive_formats.h"
#include "model/simulator/road.h"
#include "model/simulator/simulator.h"
#include "tests/support/calibration_checks.h"
#include "tests/support/kept_scans.h"

namespace remount::testing {

struct Yard {
  std::vector<std::shared_ptr<const drive::Session>> sessions;
  RigidTransform machine_from_lidar;  // origin on the ground
};

inline simulator::SimulatedDrive recording(simulator::SlewRecording kind, const simulator::SlewYardOptions& yard,
                                           int seed) {
  simulator::SimulationOptions options;
  options.scenario = simulator::ScenarioKind::SlewYard;
  options.slew_yard = yard;
  options.slew_yard.recording = kind;
  options.beams = 32;
  options.azimuth_steps = 500;
  options.range_noise_m = 0.01;
  options.duration_s = kind == simulator::SlewRecording::Ground     ? 0.5
                       : kind == simulator::SlewRecording::ArmSweep ? 4.0
                                                                    : 24.0;
  options.scan_rate_hz = kind == simulator::SlewRecording::FullTurn ? 5.0 : 10.0;
  options.seed = seed;
  return testing::simulate_drive(options);
}

/// @param by_poses the turn is given by true poses of the LiDAR instead of its scans: quicker
inline Yard yard_of(const simulator::SlewYardOptions& options, bool by_poses, int seed = 3) {
  Yard yard;
  const std::pair<simulator::SlewRecording, const char*> kinds[] = {{simulator::SlewRecording::FullTurn, "full turn"},
                                                                    {simulator::SlewRecording::Ground, "the ground"},
                                                                    {simulator::SlewRecording::ArmSweep, "arm swept"}};
  for (const auto& [kind, name] : kinds) {  // in any order: their names say which they are
    simulator::SimulatedDrive drive = recording(kind, options, seed);
    drive.session.name = name;
    yard.machine_from_lidar = simulator::vehicle_from_ins(simulator::ScenarioKind::SlewYard) * drive.ins_from_lidar;
    if (by_poses && kind == simulator::SlewRecording::FullTurn) {
      drive.session.odometry_from_lidar = simulator::exact_odometry(drive);
      drive.session.scans = nullptr;
    }
    yard.sessions.push_back(std::make_shared<const drive::Session>(std::move(drive.session)));
  }
  return yard;
}

inline pipeline::PipelineOutput run(const Yard& yard, const settings::Settings& settings) {
  pipeline::PipelineInput input;
  input.sessions = yard.sessions;
  input.settings = settings;
  Progress progress;
  return methods::run_slew(input, progress);
}

inline settings::Settings settings_with(calibration::FirstPlane first) {
  settings::Settings settings;
  settings.slew.first_plane = first;
  settings.slew.origin = calibration::MachineOrigin::Ground;
  return settings;
}

/// Squared errors in units of what is stated, order of kParameters.
inline std::array<double, 6> squares_of(const Yard& yard, calibration::FirstPlane first, bool print) {
  settings::Settings settings = settings_with(first);
  settings.slew.surface_sigma_deg = 0.0;  // ground and arm of the yard are planes
  const pipeline::PipelineOutput output = run(yard, settings);
  if (print) {
    error_of(output.result, yard.machine_from_lidar);
    for (std::size_t i = 0; i < 6; ++i)
      std::printf("  %s +- %.5f", std::string(to_string(calibration::kParameters[i])).c_str(),
                  output.result.estimate(calibration::kParameters[i]).sigma.value_or(NAN));
    std::printf(" (m, rad)\n");
  }
  EXPECT_EQ(output.result.status, calibration::Status::Ok) << english(output.result.message);
  std::array<double, 6> squares = normalised_errors(output.result, yard.machine_from_lidar);
  for (double& error : squares) error *= error;
  return squares;
}

inline constexpr std::array kFirstPlanes{calibration::FirstPlane::Ground, calibration::FirstPlane::Turn};

/// How far the parameters scatter over simulated recordings, in units of what is stated: squares, mean of `seeds`, for
/// each of kFirstPlanes.
inline std::array<std::array<double, 6>, 2> squares_over_recordings(int first_seed, int seeds,
                                                                    const simulator::SlewYardOptions& options = {}) {
  std::array<std::array<double, 6>, 2> squares{};
  for (int seed = first_seed; seed < first_seed + seeds; ++seed) {
    const Yard yard = yard_of(options, false, seed);
    for (std::size_t plane = 0; plane < kFirstPlanes.size(); ++plane) {
      const std::array<double, 6> one = squares_of(yard, kFirstPlanes[plane], seed == first_seed);
      for (std::size_t i = 0; i < 6; ++i) squares[plane][i] += one[i] / seeds;
    }
  }
  for (std::size_t plane = 0; plane < kFirstPlanes.size(); ++plane) {
    std::printf("  chi-square over %d recordings, slope %.0f deg, first plane %s:", seeds, options.slope_deg,
                kFirstPlanes[plane] == calibration::FirstPlane::Turn ? "turn" : "ground");
    for (std::size_t i = 0; i < 6; ++i)
      std::printf(" %s %.2f", std::string(to_string(calibration::kParameters[i])).c_str(), squares[plane][i]);
    std::printf("\n");
  }
  return squares;
}

}  // namespace remount::testing
