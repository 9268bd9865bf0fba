// Clocks of sensor and vehicle that are apart, on simulated drives.
#include "model/methods/vehicle_frame/vehicle_clock.h"

#include <gtest/gtest.h>

#include <cstdio>
#include <random>

#include "algorithms/calibration/observability.h"
#include "model/methods/vehicle_frame/vehicle_frame_method.h"
#include "model/pipeline/pipeline.h"
#include "model/simulator/road.h"
#include "model/simulator/simulator.h"
#include "tests/algorithms/support/random_motion.h"
#include "tests/support/calibration_checks.h"

namespace remount::methods {
namespace {

struct ClockedDrive {
  std::shared_ptr<drive::Session> session;
  RigidTransform vehicle_from_lidar;
};

// Poses of the LiDAR by an odometry with errors, stamped by a clock with t_vehicle = t_lidar + offset.
ClockedDrive clocked_drive(double offset_s, std::uint64_t seed) {
  simulator::SimulationOptions options;
  options.scenario = simulator::ScenarioKind::Street;
  options.duration_s = 60.0;
  options.speed_mps = 8.0;
  options.seed = seed;
  simulator::SimulatedDrive drive = simulator::simulate_drive(options);
  ClockedDrive out;
  out.vehicle_from_lidar = simulator::vehicle_from_ins(options.scenario) * drive.ins_from_lidar;
  out.session = std::make_shared<drive::Session>(std::move(drive.session));
  out.session->scans = nullptr;
  std::mt19937_64 random(seed);
  RigidTransform odometry = RigidTransform::Identity();
  for (std::size_t i = 0; i < drive.enu_from_ins.size(); ++i) {
    const RigidTransform now = drive.enu_from_ins[i].pose * drive.ins_from_lidar;
    if (i > 0) {
      const RigidTransform before = drive.enu_from_ins[i - 1].pose * drive.ins_from_lidar;
      odometry = odometry * perturb(before.inverse() * now, testing::random_step(random, 0.005, 5e-4));
    }
    out.session->odometry_from_lidar.push_back(
        {drive.enu_from_ins[i].stamp_ns - static_cast<std::int64_t>(std::llround(offset_s * 1e9)), odometry});
  }
  return out;
}

pipeline::PipelineOutput solved(const ClockedDrive& drive, calibration::ClockOffsetUse use) {
  pipeline::PipelineInput input;
  input.sessions = {drive.session};
  input.settings.solve.apply_time_offset = use;
  Progress progress;
  return run_vehicle_frame(input, progress);
}

const drive::Finding* clock_finding(const pipeline::PipelineOutput& output) {
  for (const drive::Finding& finding : output.findings)
    if (finding.code == "clock-offset") return &finding;
  return nullptr;
}

TEST(vehicle_clock, an_offset_of_the_clocks_is_taken_out_and_said) {
  for (std::uint64_t seed = 41; seed <= 44; ++seed)
    for (const double offset_s : {-0.06, 0.03, 0.1}) {
      const ClockedDrive drive = clocked_drive(offset_s, seed);
      const pipeline::PipelineOutput output = solved(drive, calibration::ClockOffsetUse::Auto);
      const calibration::TimeOffset& clock = output.result.time_offset;
      std::printf("  offset %.4f +- %.4f s for %.2f\n", clock.offset_s, clock.sigma_s, offset_s);
      testing::expect_within_sigma(output.result, drive.vehicle_from_lidar, 3.5);
      EXPECT_TRUE(clock.applied);
      EXPECT_LT(std::abs(clock.offset_s - offset_s), 4.0 * clock.sigma_s);
      const drive::Finding* const told = clock_finding(output);
      ASSERT_TRUE(told);
      EXPECT_EQ(told->severity, drive::Severity::Note);
    }
}

TEST(vehicle_clock, an_offset_that_is_not_taken_out_is_in_the_sigmas) {
  for (std::uint64_t seed = 45; seed <= 48; ++seed) {
    const ClockedDrive drive = clocked_drive(-0.08, seed);
    const pipeline::PipelineOutput output = solved(drive, calibration::ClockOffsetUse::No);
    testing::expect_within_sigma(output.result, drive.vehicle_from_lidar, 3.5);
    EXPECT_FALSE(output.result.time_offset.applied);
    const drive::Finding* const told = clock_finding(output);
    ASSERT_TRUE(told);
    EXPECT_EQ(told->severity, drive::Severity::Warning);
  }
}

TEST(vehicle_clock, clocks_that_agree_are_left_alone) {
  for (std::uint64_t seed = 49; seed <= 52; ++seed) {
    const ClockedDrive drive = clocked_drive(0.0, seed);
    const pipeline::PipelineOutput output = solved(drive, calibration::ClockOffsetUse::Auto);
    testing::expect_within_sigma(output.result, drive.vehicle_from_lidar, 3.5);
    EXPECT_FALSE(output.result.time_offset.applied);
    EXPECT_FALSE(clock_finding(output));
  }
}

// X moves along x by 2 m for a second; nothing is usable where the clock is off by more than `bears_s`.
calibration::CalibrationResult moved_solution(double offset_s, double bears_s) {
  calibration::CalibrationResult result;
  result.status = std::abs(offset_s) <= bears_s ? calibration::Status::Ok : calibration::Status::NotConverged;
  if (result.status == calibration::Status::Ok) result.set_observed(calibration::ParameterSet::all(), {});
  result.mounting.reference = calibration::BodyFrame::Vehicle;
  result.mounting.reference_from_sensor.translation().x() = 2.0 * offset_s;
  return result;
}

TEST(vehicle_clock, an_offset_that_leaves_nothing_usable_is_no_offset_that_does_nothing) {
  const calibration::SolveOptions options;
  for (const double bears_s : {0.1, 0.03, 0.015, 0.001}) {
    const Vector6d moved = moved_by_clock(0.04, RigidTransform::Identity(), options,
                                          [&](double offset_s) { return moved_solution(offset_s, bears_s); });
    std::printf("  usable up to %.3f s: X moves by %.3f m\n", bears_s, moved[0]);
    if (bears_s > 0.01)
      EXPECT_NEAR(std::abs(moved[0]), 0.08, 1e-9) << bears_s;
    else
      EXPECT_GT(moved.cwiseQuotient(calibration::observation_limits(options)).minCoeff(), 10.0) << "nothing is known";
  }
  const Vector6d one_way = moved_by_clock(0.04, RigidTransform::Identity(), options, [](double offset_s) {
    return moved_solution(offset_s, offset_s < 0.0 ? 1.0 : 0.0);
  });
  EXPECT_NEAR(std::abs(one_way[0]), 0.08, 1e-9) << "the other way tells as well";
}

}  // namespace
}  // namespace remount::methods
