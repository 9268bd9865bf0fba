// Vehicles with several LiDARs: each mounting, and where they sit against each other.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <map>

#include "algorithms/core/index.h"
#include "algorithms/core/parallel.h"
#include "algorithms/messages/render.h"
#include "model/methods/calibrate.h"
#include "model/rig/rig_calibration.h"
#include "model/rig/rig_findings.h"
#include "model/simulator/simulator.h"
#include "tests/support/chi_square.h"
#include "tests/support/kept_scans.h"
#include "tests/support/peak_memory.h"

namespace remount::testing {
namespace {

simulator::LidarMount mount(std::string name, std::string_view model, double phase_s,
                            const RigidTransform& ins_from_lidar) {
  simulator::LidarMount out;
  out.name = std::move(name);
  out.options.lidar.model = simulator::lidar_named(model);
  out.options.ins_from_lidar = ins_from_lidar;
  out.options.scan_phase_s = phase_s;
  return out;
}

RigidTransform at(double x_m, double y_m, double z_m, double yaw_deg, double pitch_deg, double roll_deg) {
  return rigid_from_six(
      {x_m, y_m, z_m, degrees_to_radians(yaw_deg), degrees_to_radians(pitch_deg), degrees_to_radians(roll_deg)});
}

struct SixErrors {
  std::array<std::vector<double>, 6> over_sigma;
  std::array<double, 6> largest{};

  void add(const RigidTransform& truth, const RigidTransform& found, const std::array<double, 6>& sigmas) {
    const auto wanted = calibration::parameters_of(truth), is = calibration::parameters_of(found);
    for (const calibration::Parameter parameter : calibration::kParameters) {
      const auto row = static_cast<std::size_t>(row_of(parameter));
      double error = is[parameter] - wanted[parameter];
      if (calibration::is_angle(parameter)) error = std::remainder(error, 2.0 * kPi);
      const double unit = calibration::is_angle(parameter) ? 1e3 * 180.0 / kPi : 1e3;
      std::printf(" %6.1f(%.1f)", unit * error, unit * sigmas[row]);
      if (!std::isfinite(sigmas[row])) continue;
      largest[row] = std::max(largest[row], std::abs(unit * error));
      over_sigma[row].push_back(error / sigmas[row]);
    }
    std::printf("\n");
  }
  /// @param most of x and y, of z (mm), and of each angle (mdeg)
  void expect(const std::string& what, const std::array<double, 3>& most) const {
    for (std::size_t i = 0; i < 6; ++i) {
      const std::size_t count = over_sigma[i].size();
      EXPECT_LE(largest[i], most[i < 2 ? 0 : i == 2 ? 1 : 2]) << what << " parameter " << i;
      double sum = 0.0;
      for (const double value : over_sigma[i]) sum += value * value;
      if (count > 9) {
        EXPECT_LT(sum, chi_square_quantile(static_cast<double>(count), kOnePercentOutside))
            << what << " parameter " << i;
      }
    }
  }
  void print(const std::string& what) const {
    std::printf("%-24s mean square over sigma, largest (mm, mdeg):", what.c_str());
    for (std::size_t i = 0; i < 6; ++i) {
      double sum = 0.0;
      for (const double value : over_sigma[i]) sum += value * value;
      std::printf("  %.2f %.1f", over_sigma[i].empty() ? NAN : sum / static_cast<double>(over_sigma[i].size()),
                  largest[i]);
    }
    std::printf("\n");
  }
};

double processor_time_s() {
  timespec time{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

int from_environment(const char* name, int otherwise) {
  const char* text = std::getenv(name);
  return text ? std::atoi(text) : otherwise;
}
int first_seed(int otherwise) { return from_environment("REMOUNT_FIRST_SEED", otherwise); }
int count_of(int otherwise) { return from_environment("REMOUNT_VEHICLES", otherwise); }

// Scans are cast beforehand.
std::vector<rig::LidarJob> jobs_of(simulator::SimulatedVehicle vehicle) {
  std::vector<rig::LidarJob> jobs;
  for (simulator::SimulatedDrive& lidar : vehicle.lidars) {
    lidar.session.scans = std::make_shared<const KeptScans>(lidar.session.scans);
    parallel_for(lidar.session.scans->size(), 0, [&](std::size_t i) { (void)lidar.session.scans->load(i); });
    rig::LidarJob job;
    job.name = lidar.session.lidar_name;
    job.input.sessions.push_back(std::make_shared<drive::Session>(lidar.session));
    job.input.settings.run.map_check = false;
    job.recordings = {motion::SessionIndex{0}};
    jobs.push_back(std::move(job));
  }
  return jobs;
}

struct VehicleErrors {
  std::map<std::string, SixErrors> of_lidars, of_two, alone;  ///< alone: what each LiDAR's own calibration gave
};

std::array<double, 6> sigmas_of(const calibration::CalibrationResult& result) {
  std::array<double, 6> sigmas;
  for (const calibration::Parameter parameter : calibration::kParameters)
    sigmas[static_cast<std::size_t>(row_of(parameter))] = result.estimate(parameter).sigma.value_or(NAN);
  return sigmas;
}

// Calibrates drives of the vehicle and prints what each gives: errors, with sigma in brackets.
VehicleErrors calibrate_vehicles(simulator::SimulationOptions options, const std::vector<simulator::LidarMount>& mounts,
                                 int first_seed, int count) {
  VehicleErrors drives;
  for (int seed = first_seed; seed < first_seed + count; ++seed) {
    options.seed = seed;
    const simulator::SimulatedVehicle vehicle = simulator::simulate_vehicle(options, mounts);
    const std::vector<rig::LidarJob> jobs = jobs_of(vehicle);
    const double begun_s = processor_time_s();
    Progress progress;
    const rig::RigOutput output = rig::calibrate_rig(jobs, progress);
    std::printf("seed %d: %.1f s, %zu groups, cross pairs", seed, processor_time_s() - begun_s, output.groups.size());
    std::map<std::pair<std::size_t, std::size_t>, std::array<int, 2>> counts;
    for (const calibration::CrossPair& cross : output.cross_pairs) {
      auto& [accepted, all] = counts[{cross.lidar_a, cross.lidar_b}];
      ++all, accepted += cross.pair.state == motion::PairState::Accepted;
    }
    for (const auto& [two, count_of_two] : counts)
      std::printf(" %zu-%zu %d/%d", two.first, two.second, count_of_two[0], count_of_two[1]);
    std::printf("\n");
    for (const drive::Finding& finding : output.findings)
      std::printf("  %s %s: %s\n", english(finding.where).c_str(), finding.code.c_str(),
                  english(finding.explanation).c_str());
    EXPECT_TRUE(output.solved);
    EXPECT_EQ(output.groups.size(), 1u) << "joined by what they see";
    for (std::size_t l = 0; l < output.lidars.size(); ++l) {
      const rig::LidarOutput& lidar = output.lidars[l];
      const calibration::CalibrationResult& result = lidar.output.result;
      std::printf("  %-16s", lidar.name.c_str());
      drives.of_lidars[lidar.name].add(vehicle.lidars[l].ins_from_lidar, result.mounting.reference_from_sensor,
                                       sigmas_of(result));
      if (!lidar.alone) continue;
      std::printf("    alone         ");
      drives.alone[lidar.name].add(vehicle.lidars[l].ins_from_lidar, lidar.alone->result.mounting.reference_from_sensor,
                                   sigmas_of(lidar.alone->result));
    }
    for (const calibration::RelativeMounting& two : output.relatives) {
      const std::string name = output.lidars[two.lidar_a].name + "-" + output.lidars[two.lidar_b].name;
      std::array<double, 6> sigmas;
      for (const calibration::Parameter parameter : calibration::kParameters) {
        const int row = row_of(parameter);
        sigmas[static_cast<std::size_t>(row)] =
            two.observed.contains(parameter) ? std::sqrt(two.covariance(row, row)) : NAN;
      }
      std::printf("  %-16s", name.c_str());
      drives.of_two[name].add(calibration::relative_mounting(vehicle.lidars[two.lidar_a].ins_from_lidar,
                                                             vehicle.lidars[two.lidar_b].ins_from_lidar),
                              two.lidar_a_from_lidar_b, sigmas);
    }
    for (const rig::SharedSurfaces& two : output.surfaces)
      std::printf("  %s and %s: %.2f mm apart alone, %.2f together\n", output.lidars[two.lidar_a].name.c_str(),
                  output.lidars[two.lidar_b].name.c_str(), 1e3 * two.separate_m, 1e3 * two.together_m);
    for (const Message& words : rig::words_of_heights(output)) std::printf("  %s\n", english(words).c_str());
    std::fflush(stdout);
  }
  for (const auto& [name, errors] : drives.alone) errors.print(name + " alone");
  for (const auto& [name, errors] : drives.of_lidars) errors.print(name);
  for (const auto& [name, errors] : drives.of_two) errors.print(name);
  return drives;
}

std::vector<simulator::LidarMount> four_lidars() {
  std::vector<simulator::LidarMount> mounts{mount("front", "m1", 0.0, at(2.1, 0.1, 0.6, 0.7, -0.6, 0.4)),
                                            mount("side", "m1", 0.037, at(1.6, 0.8, 0.9, 62.4, 1.1, -0.7)),
                                            mount("rear", "rosette", 0.061, at(-1.3, -0.1, 1.0, 178.6, 0.8, 0.5)),
                                            mount("top", "spinning", 0.083, at(0.4, 0.0, 1.7, -91.0, 0.4, 1.2))};
  mounts[0].options.lidar.points_per_scan = mounts[1].options.lidar.points_per_scan = 20000;
  mounts[3].options.beams = 16;
  return mounts;
}

simulator::SimulationOptions drive_of(simulator::ScenarioKind scenario, double duration_s = 20.0) {
  simulator::SimulationOptions options;
  options.scenario = scenario;
  options.duration_s = duration_s;
  return options;
}

TEST(vehicles, four_lidars_in_a_figure_of_eight) {
  const VehicleErrors errors =
      calibrate_vehicles(drive_of(simulator::ScenarioKind::FigureEight), four_lidars(), first_seed(1), count_of(30));
  for (const auto& [name, of_lidar] : errors.of_lidars)
    of_lidar.expect(name, name == "rear" ? std::array{8.0, 30.0, 50.0} : std::array{3.0, 20.0, 20.0});
  for (const auto& [names, of_two] : errors.of_two) of_two.expect(names, {3.0, 5.0, 15.0});
}

TEST(vehicles, four_lidars_on_flat_ground) {
  const VehicleErrors errors =
      calibrate_vehicles(drive_of(simulator::ScenarioKind::Flat), four_lidars(), first_seed(1), count_of(6));
  for (const auto& [name, of_lidar] : errors.of_lidars)
    EXPECT_TRUE(of_lidar.over_sigma[2].empty()) << name << " claims a height";
  for (const auto& [names, of_two] : errors.of_two) of_two.expect(names, {3.0, 5.0, 15.0});
}

// Errors of beams are unknowns of each LiDAR, and pairs across them bear the errors of both.
TEST(vehicles, four_lidars_whose_beams_err) {
  std::vector<simulator::LidarMount> mounts = four_lidars();
  for (simulator::LidarMount& lidar : mounts) {
    const bool spins = lidar.name == "top";
    (spins ? lidar.options.lidar_errors.ring_elevation_deg : lidar.options.lidar_errors.field_angle_deg) = 0.05;
    (spins ? lidar.options.lidar_errors.ring_range_m : lidar.options.lidar_errors.field_range_m) = 0.01;
  }
  const VehicleErrors errors =
      calibrate_vehicles(drive_of(simulator::ScenarioKind::FigureEight), mounts, first_seed(1), count_of(12));
  for (const auto& [name, of_lidar] : errors.of_lidars) of_lidar.expect(name, {20.0, 80.0, 100.0});
  for (const auto& [names, of_two] : errors.of_two) of_two.expect(names, {20.0, 80.0, 100.0});
}

// At no moment do they see the same.
TEST(vehicles, front_and_rear_without_a_common_field) {
  const std::vector<simulator::LidarMount> mounts{mount("front", "mid-70", 0.0, at(2.1, 0.1, 0.6, 0.7, -0.6, 0.4)),
                                                  mount("rear", "mid-70", 0.047, at(-1.3, -0.1, 1.0, 178.6, 0.8, 0.5))};
  for (const auto scenario : {simulator::ScenarioKind::FigureEight, simulator::ScenarioKind::Street}) {
    const VehicleErrors errors = calibrate_vehicles(drive_of(scenario), mounts, first_seed(1), count_of(10));
    for (const auto& [names, of_two] : errors.of_two) of_two.expect(names, {8.0, 8.0, 30.0});
    for (const auto& [name, of_lidar] : errors.of_lidars) of_lidar.expect(name, {8.0, 50.0, 50.0});
  }
}

TEST(vehicles, eight_lidars_take_little_more_than_each_alone) {
  simulator::SimulationOptions options = drive_of(simulator::ScenarioKind::FigureEight, 60.0);
  std::vector<simulator::LidarMount> mounts = four_lidars();
  for (simulator::LidarMount more : four_lidars()) {
    more.name += "-2";
    more.options.ins_from_lidar.translation().y() -= 0.9;
    more.options.ins_from_lidar.rotate(Eigen::AngleAxisd(degrees_to_radians(-40.0), Eigen::Vector3d::UnitZ()));
    mounts.push_back(std::move(more));
  }
  options.seed = first_seed(1);
  const std::vector<rig::LidarJob> jobs = jobs_of(simulator::simulate_vehicle(options, mounts));
  Progress progress;
  double begun_s = processor_time_s();
  for (const rig::LidarJob& job : jobs) (void)methods::calibrate(job.input, progress);
  const double alone_s = processor_time_s() - begun_s;
  begun_s = processor_time_s();
  const rig::RigOutput output = rig::calibrate_rig(jobs, progress);
  const double together_s = processor_time_s() - begun_s;
  std::printf("eight alone %.1f s, together %.1f s (%.2f times), %zu cross pairs, peak %.0f MB\n", alone_s, together_s,
              together_s / alone_s, output.cross_pairs.size(), peak_mb());
  EXPECT_TRUE(output.solved);
  EXPECT_LT(together_s, 1.4 * alone_s);
}

}  // namespace
}  // namespace remount::testing
