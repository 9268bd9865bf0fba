#include "model/simulator/simulator.h"

#include <memory>
#include <utility>

#include "algorithms/core/error.h"
#include "messages/parameters.h"
#include "messages/simulation.h"
#include "model/simulator/ins_model.h"
#include "model/simulator/lidar_model.h"

namespace remount::simulator {

namespace {

constexpr double kLongestDrive_m = 200'000.0;
constexpr double kMostSamples = 2e7;  ///< of one sensor

/// What makes no drive, or no LiDAR of it.
std::vector<Message> problems_of(const SimulationOptions& options) {
  std::vector<Message> problems;
  for (auto& problem : option_problems(options)) problems.emplace_back(std::move(problem));
  if (options.duration_s * options.speed_mps > kLongestDrive_m)
    problems.push_back(say::simulation_drive_too_long(Length{kLongestDrive_m}));
  const auto has_too_many = [&](double rate_hz) { return options.duration_s * rate_hz > kMostSamples; };
  if (has_too_many(options.ins_rate_hz)) problems.push_back(say::simulation_too_many_ins());
  if (has_too_many(options.imu.rate_hz)) problems.push_back(say::simulation_too_many_imu());
  if (has_too_many(options.wheels.rate_hz)) problems.push_back(say::simulation_too_many_wheel());
  if (options.lidar_errors.mixed_pixels > 0.0 && options.lidar_errors.divergence_mrad <= 0.0)
    problems.push_back(say::simulation_mixed_pixels_of_thin_beams());
  if (!(options.scan_phase_s >= 0.0 && options.scan_phase_s < options.duration_s))
    problems.push_back(say::simulation_phase(Duration{options.scan_phase_s}));
  if (!options.ins_from_lidar.matrix().allFinite())
    problems.push_back(say::simulation_mounting_not_finite("ins_from_lidar"));
  if (!options.imu.ins_from_imu.matrix().allFinite())
    problems.push_back(say::simulation_mounting_not_finite("ins_from_imu"));
  return problems;
}

/// Throws Error(Contract) where there are some.
void check(std::vector<Message> problems, const std::string& where = "simulation options") {
  if (!problems.empty()) throw Error(ErrorCode::Contract, where, in_one(std::move(problems)));
}

std::string scenario_name(ScenarioKind scenario) {
  constexpr const char* names[] = {"street", "flat",    "straight", "figure-eight", "parking-ramp",
                                   "hill",   "highway", "tunnel",   "slew-yard"};
  return names[static_cast<int>(scenario)];
}

void add_sensors(const Scene& scene, SimulatedDrive& drive) {
  SimulatedImu imu = simulate_imu(scene);
  SimulatedGnss gnss = simulate_gnss(scene);
  const SimulationOptions& options = scene.options();
  drive.sensors = {
      scene.vehicle_from_ins(), options.imu.ins_from_imu, options.gnss.antenna_in_ins_m, kTrack_m, {}, {}, {}, {}};
  if (!imu.errors.empty()) {
    drive.sensors.imu_at_start = imu.errors.front();
    drive.sensors.imu_at_end = imu.errors.back();
  }
  drive.sensors.gnss_outlier_stamps_ns = std::move(gnss.outlier_stamps_ns);
  drive.session.imu = std::move(imu.samples);
  drive.session.gnss = std::move(gnss.fixes);
  drive.session.wheels = simulate_wheels(scene);
  drive.session.barometer = simulate_barometer(scene);
}

/// What readers would know of the LiDAR's times. Of one that does not spin nothing follows from azimuths.
void tell_timing(const SimulationOptions& options, drive::Session& session) {
  const bool spins = lidar_model(options.lidar.model).spins;
  session.scan_timing = !options.motion_distortion ? drive::ScanTiming::Instant
                        : options.per_point_time   ? drive::ScanTiming::PerPoint
                        : spins                    ? drive::ScanTiming::SweepAzimuth
                                                   : drive::ScanTiming::Unknown;
  session.sweep = {1.0 / options.scan_rate_hz, 0.0, options.clockwise, spins};
  session.sweep.direction_known = spins;
  session.sweep.by_order = !spins;
}

/// The drive without its LiDAR.
SimulatedDrive drive_of_vehicle(const Scene& scene) {
  const SimulationOptions& options = scene.options();
  SimulatedDrive drive;
  drive::Session& session = drive.session;
  session.name = "simulated-" + scenario_name(options.scenario) + "-" + std::to_string(options.seed);
  session.format = "simulated";
  session.ins = simulate_ins(scene);
  add_sensors(scene, drive);
  session.ins_position_white_sigma_m = options.ins_position_noise_m;
  session.ins_attitude_white_sigma_rad = degrees_to_radians(options.ins_attitude_noise_deg);
  session.ins_attitude_bias_sigma_rad = degrees_to_radians(options.ins_attitude_bias_deg);
  session.ins_position_drift = options.ins_position_drift_m;
  session.ins_attitude_drift = degrees_to_radians(options.ins_attitude_drift_deg);
  return drive;
}

void add_lidar(const std::shared_ptr<const Scene>& scene, const SimulationOptions& options, SimulatedDrive& drive) {
  drive.ins_from_lidar = options.ins_from_lidar;
  for (std::size_t scan = 0; scan < scan_count(options); ++scan) {
    const double time_s = scan_time_s(options, scan);
    drive.enu_from_ins.push_back({kDriveStart_ns + std::llround(time_s * 1e9), scene->enu_from_ins(time_s)});
  }
  const auto scans = std::make_shared<const SimulatedScanSource>(scene, options);
  drive.sensors.lidar = scans->truth();
  if (drive.sensors.lidar.perfect()) drive.session.lidar = cloud::LidarKind::Perfect;
  drive.session.scans = scans;
  tell_timing(options, drive.session);
}

}  // namespace

SimulatedDrive simulate_drive(const SimulationOptions& options) {
  check(problems_of(options));
  const auto scene = std::make_shared<const Scene>(options);
  SimulatedDrive drive = drive_of_vehicle(*scene);
  add_lidar(scene, options, drive);
  return drive;
}

SimulatedVehicle simulate_vehicle(const SimulationOptions& options, const std::vector<LidarMount>& mounts) {
  check(problems_of(options));
  check(mount_problems(mounts), "mounts");
  for (const LidarMount& mount : mounts) check(problems_of(options_of_mount(options, mount)), "mount " + mount.name);
  const auto scene = std::make_shared<const Scene>(options);
  const SimulatedDrive of_vehicle = drive_of_vehicle(*scene);
  SimulatedVehicle vehicle;
  for (const LidarMount& mount : mounts) {
    SimulatedDrive& drive = vehicle.lidars.emplace_back(of_vehicle);
    drive.session.lidar_name = mount.name;
    add_lidar(scene, options_of_mount(options, mount), drive);
  }
  return vehicle;
}

}  // namespace remount::simulator
