#include "model/rig/rig_calibration.h"

#include <gtest/gtest.h>

#include <cmath>
#include <iostream>

#include "algorithms/core/error.h"
#include "algorithms/messages/render.h"
#include "model/methods/calibrate.h"
#include "model/results/result_file.h"
#include "model/rig/rig_findings.h"
#include "model/simulator/simulator.h"
#include "tests/support/draws.h"
#include "tests/support/kept_scans.h"

namespace remount::rig {
namespace {

simulator::LidarMount mount(std::string name, double phase_s, const SixParameters& ins_from_lidar) {
  simulator::LidarMount out;
  out.name = std::move(name);
  out.options.beams = 24;
  out.options.azimuth_steps = 360;
  out.options.scan_phase_s = phase_s;
  out.options.ins_from_lidar = rigid_from_six(ins_from_lidar);
  return out;
}

std::vector<simulator::LidarMount> two_mounts(double rear_turned_rad = 0.0) {
  return {mount("front", 0.0, {1.9, 0.1, 0.8, 0.02, 0.03, -0.01}),
          mount("rear", 0.04, {-1.2, -0.2, 1.1, 2.9 + rear_turned_rad, -0.02, 0.02})};
}

simulator::SimulatedVehicle short_drive(int seed, const std::vector<simulator::LidarMount>& mounts) {
  simulator::SimulationOptions options;
  options.scenario = simulator::ScenarioKind::FigureEight;
  options.duration_s = 8.0;
  options.seed = seed;
  simulator::SimulatedVehicle vehicle = simulator::simulate_vehicle(options, mounts);
  for (simulator::SimulatedDrive& lidar : vehicle.lidars)
    lidar.session.scans = std::make_shared<const testing::KeptScans>(lidar.session.scans);
  return vehicle;
}

/// With what was recorded on each of the drives.
std::vector<LidarJob> jobs_of(const std::vector<simulator::SimulatedVehicle>& drives) {
  std::vector<LidarJob> jobs;
  for (std::size_t l = 0; l < drives.front().lidars.size(); ++l) {
    LidarJob job;
    job.name = drives.front().lidars[l].session.lidar_name;
    for (std::size_t d = 0; d < drives.size(); ++d) {
      drive::Session session = drives[d].lidars[l].session;
      session.path += "-" + std::to_string(d);
      job.input.sessions.push_back(std::make_shared<drive::Session>(std::move(session)));
      job.recordings.emplace_back(d);
    }
    job.input.nominal_ins_from_lidar = perturb(drives.front().lidars[l].ins_from_lidar,
                                               (Vector6d() << 0.05, -0.05, 0.05, 0.02, -0.02, 0.02).finished());
    job.input.settings.pairing.max_partners = 4;
    job.input.settings.run.map_check = false;
    jobs.push_back(std::move(job));
  }
  return jobs;
}

bool has_finding(const RigOutput& output, const char* code, const char* where) {
  return std::ranges::any_of(output.findings, [&](const drive::Finding& finding) {
    return finding.code == code && english(finding.where) == where;
  });
}

TEST(rig_calibration, joins_lidars_by_what_they_see) {
  const simulator::SimulatedVehicle vehicle = short_drive(1, two_mounts());
  Progress progress;
  const std::vector<LidarJob> jobs = jobs_of({vehicle});
  const RigOutput output = calibrate_rig(jobs, progress);
  ASSERT_TRUE(output.solved);
  const RigOutput again = solve_rig_again(jobs, {output.lidars[0].alone, output.lidars[1].alone}, progress);
  ASSERT_TRUE(again.solved);
  for (std::size_t l = 0; l < 2; ++l)
    EXPECT_LT(difference(output.lidars[l].output.result.mounting.reference_from_sensor,
                         again.lidars[l].output.result.mounting.reference_from_sensor)
                  .norm(),
              1e-12)
        << "from what each is alone, as before";
  EXPECT_TRUE(output.findings.empty()) << english(output.findings.front().explanation);
  ASSERT_EQ(output.groups.size(), 1u);
  for (std::size_t l = 0; l < 2; ++l) {
    const calibration::CalibrationResult& result = output.lidars[l].output.result;
    EXPECT_TRUE(output.lidars[l].joined);
    const auto truth = calibration::parameters_of(vehicle.lidars[l].ins_from_lidar);
    for (const calibration::Parameter parameter : calibration::kParameters) {
      const calibration::Estimate estimate = result.estimate(parameter);
      ASSERT_TRUE(estimate.observed) << output.lidars[l].name << to_string(parameter);
      EXPECT_LT(std::abs(estimate.value - truth[parameter]), 4.5 * *estimate.sigma)
          << output.lidars[l].name << " " << to_string(parameter) << " off by " << estimate.value - truth[parameter];
    }
  }
  ASSERT_EQ(output.relatives.size(), 1u);
  const calibration::RelativeMounting& two = output.relatives.front();
  const auto truth = calibration::parameters_of(
      calibration::relative_mounting(vehicle.lidars[0].ins_from_lidar, vehicle.lidars[1].ins_from_lidar));
  const auto found = calibration::parameters_of(two.lidar_a_from_lidar_b);
  for (const calibration::Parameter parameter : calibration::kParameters) {
    const double sigma = std::sqrt(two.covariance(row_of(parameter), row_of(parameter)));
    EXPECT_LT(std::abs(found[parameter] - truth[parameter]), 4.5 * sigma) << to_string(parameter);
  }
  EXPECT_LT(two.height_sigma_m, 0.3 * *output.lidars[0].output.result.estimate(calibration::Parameter::Z).sigma);
  ASSERT_EQ(output.surfaces.size(), 1u);
  EXPECT_LT(output.surfaces[0].together_m, 1.01 * output.surfaces[0].separate_m);
  EXPECT_LT(output.surfaces[0].together_m, 0.06);
  std::size_t accepted = 0;
  for (const calibration::CrossPair& cross : output.cross_pairs)
    accepted += cross.pair.state == motion::PairState::Accepted ? 1 : 0;
  EXPECT_GT(accepted, 20u) << "of " << output.cross_pairs.size();
}

TEST(rig_calibration, a_lidar_that_turned_between_drives_is_named_and_the_others_stay) {
  const simulator::SimulatedVehicle before = short_drive(2, two_mounts()),
                                    after = short_drive(3, two_mounts(degrees_to_radians(0.3)));
  Progress progress;
  const std::vector<LidarJob> jobs = jobs_of({before, after});
  const RigOutput output = calibrate_rig(jobs, progress);
  EXPECT_FALSE(output.lidars[1].joined) << "drives differ " << output.lidars[1].output.result.session_disagreement
                                        << " times, of the other "
                                        << output.lidars[0].output.result.session_disagreement;
  EXPECT_TRUE(has_finding(output, "lidar-left-out", "rear"));
  EXPECT_FALSE(has_finding(output, "lidar-left-out", "front"));
  const calibration::CalibrationResult& front = output.lidars[0].output.result;
  EXPECT_EQ(front.status, calibration::Status::Ok);
  const Vector6d off = difference(before.lidars[0].ins_from_lidar, front.mounting.ins_from_lidar());
  EXPECT_LT(off.tail<3>().norm(), degrees_to_radians(0.03)) << off.transpose();
}

TEST(rig_calibration, where_all_drives_differ_the_ins_is_named) {
  ONLY_IN_LONG_TESTS();
  std::vector<simulator::LidarMount> turned = two_mounts();
  for (simulator::LidarMount& lidar : turned)
    lidar.options.ins_from_lidar =
        Eigen::AngleAxisd(degrees_to_radians(0.3), Eigen::Vector3d::UnitZ()) * lidar.options.ins_from_lidar;
  Progress progress;
  const RigOutput output = calibrate_rig(jobs_of({short_drive(2, two_mounts()), short_drive(3, turned)}), progress);
  EXPECT_TRUE(has_finding(output, "vehicle-drives-contradict", "all LiDARs"));
  EXPECT_FALSE(has_finding(output, "lidar-left-out", "front"));
  EXPECT_FALSE(has_finding(output, "lidar-left-out", "rear"));
}

TEST(rig_calibration, one_lidar_is_calibrated_as_ever) {
  std::vector<LidarJob> jobs = jobs_of({short_drive(4, two_mounts())});
  jobs.resize(1);
  Progress progress;
  const RigOutput output = calibrate_rig(jobs, progress);
  const pipeline::PipelineOutput alone = methods::calibrate(jobs.front().input, progress);
  EXPECT_FALSE(output.solved);
  EXPECT_TRUE(output.findings.empty());
  const auto written = [](const pipeline::PipelineOutput& of) {
    results::ResultFile file;
    file.result = of.result;
    file.pairs = results::pair_records(of.keyframes, of.pairs);
    return formats::to_yaml(results::result_document(file));
  };
  EXPECT_EQ(written(output.lidars.front().output), written(alone));
}

TEST(rig_calibration, is_not_solved_where_cancelled) {
  std::stop_source stop;
  stop.request_stop();
  Progress progress(stop.get_token());
  const RigOutput output = calibrate_rig(jobs_of({short_drive(5, two_mounts())}), progress);
  EXPECT_FALSE(output.solved);
  ASSERT_FALSE(output.lidars.empty());
  EXPECT_EQ(output.lidars.front().output.result.status, calibration::Status::Cancelled);
}

TEST(rig_calibration, jobs_that_contradict_themselves_are_refused) {
  Progress progress;
  EXPECT_THROW(calibrate_rig({}, progress), Error);
  std::vector<LidarJob> twice = jobs_of({short_drive(6, two_mounts())});
  twice[1].name = twice[0].name;
  EXPECT_THROW(calibrate_rig(twice, progress), Error);
  std::vector<LidarJob> unknown = jobs_of({short_drive(6, two_mounts())});
  unknown[0].recordings.clear();
  EXPECT_THROW(calibrate_rig(unknown, progress), Error);
  std::vector<LidarJob> outside = jobs_of({short_drive(5, two_mounts())});
  outside[1].input.nominal_ins_from_lidar->translation().z() = 9.0;
  try {
    calibrate_rig(outside, progress);
    ADD_FAILURE() << "the nominal lies outside";
  } catch (const Error& error) {
    EXPECT_EQ(error.where(), "nominal mounting of rear");
    EXPECT_NE(std::string(error.what()).find("z 9.00 m (at most 5.00 m)"), std::string::npos) << error.what();
  }
}

}  // namespace
}  // namespace remount::rig
