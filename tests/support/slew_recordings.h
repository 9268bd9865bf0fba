// Three recordings of a simulated excavator and the method on them.
#pragma once

#include "algorithms/messages/render.h"
#include "model/methods/slew/slew_method.h"
#include "model/pipeline/pipeline.h"
#include "model/simulator/drive_formats.h"
#include "model/simulator/road.h"
#include "model/simulator/simulator.h"
#include "tests/support/calibration_checks.h"

namespace remount {

struct Yard {
  std::vector<std::shared_ptr<const Session>> sessions;
  RigidTransform machine_from_lidar;  // origin on the ground
};

inline SimulatedDrive recording(SlewRecording kind, const SlewYardOptions& yard, int seed) {
  SimulationOptions options;
  options.scenario = ScenarioKind::SlewYard;
  options.slew_yard = yard;
  options.slew_yard.recording = kind;
  options.beams = 32;
  options.azimuth_steps = 500;
  options.range_noise_m = 0.01;
  options.duration_s = kind == SlewRecording::Ground ? 0.5 : kind == SlewRecording::ArmSweep ? 4.0 : 24.0;
  options.scan_rate_hz = kind == SlewRecording::FullTurn ? 5.0 : 10.0;
  options.seed = seed;
  return simulate_drive(options);
}

/// @param by_poses the turn is given by true poses of the LiDAR instead of its scans: quicker
inline Yard yard_of(const SlewYardOptions& options, bool by_poses, int seed = 3) {
  Yard yard;
  const std::pair<SlewRecording, const char*> kinds[] = {{SlewRecording::FullTurn, "full turn"},
                                                         {SlewRecording::Ground, "the ground"},
                                                         {SlewRecording::ArmSweep, "arm swept"}};
  for (const auto& [kind, name] : kinds) {  // in any order: their names say which they are
    SimulatedDrive drive = recording(kind, options, seed);
    drive.session.name = name;
    yard.machine_from_lidar = vehicle_from_ins(ScenarioKind::SlewYard) * drive.ins_from_lidar;
    if (by_poses && kind == SlewRecording::FullTurn) {
      drive.session.odometry_from_lidar = exact_odometry(drive);
      drive.session.scans = nullptr;
    }
    yard.sessions.push_back(std::make_shared<const Session>(std::move(drive.session)));
  }
  return yard;
}

inline PipelineOutput run(const Yard& yard, const Settings& settings) {
  PipelineInput input;
  input.sessions = yard.sessions;
  input.settings = settings;
  Progress progress;
  return run_slew(input, progress);
}

inline Settings settings_with(FirstPlane first) {
  Settings settings;
  settings.slew.first_plane = first;
  settings.slew.origin = MachineOrigin::Ground;
  return settings;
}

/// How far the parameters scatter over simulated recordings, in units of what is stated: squares, mean of `seeds`.
inline std::array<double, 6> squares_over_recordings(FirstPlane first, int first_seed, int seeds,
                                                     const SlewYardOptions& options = {}) {
  std::array<double, 6> squares{};
  for (int seed = first_seed; seed < first_seed + seeds; ++seed) {
    const Yard yard = yard_of(options, false, seed);
    Settings settings = settings_with(first);
    settings.slew.surface_sigma_deg = 0.0;  // ground and arm of the yard are planes
    const PipelineOutput output = run(yard, settings);
    if (seed == first_seed) {
      error_of(output.result, yard.machine_from_lidar);
      for (std::size_t i = 0; i < 6; ++i)
        std::printf("  %s +- %.5f", std::string(to_string(kParameters[i])).c_str(),
                    output.result.estimate(kParameters[i]).sigma.value_or(NAN));
      std::printf(" (m, rad)\n");
    }
    EXPECT_EQ(output.result.status, Status::Ok) << english(output.result.message);
    const std::array<double, 6> errors = normalised_errors(output.result, yard.machine_from_lidar);
    for (std::size_t i = 0; i < 6; ++i) squares[i] += errors[i] * errors[i] / seeds;
  }
  std::printf("  chi-square over %d recordings, slope %.0f deg, first plane %s:", seeds, options.slope_deg,
              first == FirstPlane::Turn ? "turn" : "ground");
  for (std::size_t i = 0; i < 6; ++i)
    std::printf(" %s %.2f", std::string(to_string(kParameters[i])).c_str(), squares[i]);
  std::printf("\n");
  return squares;
}

}  // namespace remount
