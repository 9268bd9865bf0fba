// What the multi-sensor odometry does where sensors fall silent, err together, or tell less than they seem to.
#include <gtest/gtest.h>

#include <iostream>

#include "algorithms/messages/render.h"
#include "tests/algorithms/odometry/synthetic_drive.h"

namespace remount::odometry {
namespace {

using synthetic::Drive;
using synthetic::lidar_only;
using synthetic::street_drive;

FusionOdometryResult solve(const Drive& drive, const std::vector<OdometryScan>& scans, const SensorStreams& streams,
                           const FusionOptions& options) {
  Progress progress;
  return solve_fusion_odometry(
      scans.size(), [&](std::size_t i) { return scans[i]; }, drive.mounting, streams, options, 1, progress);
}

std::vector<OdometryScan> scans_of(const Drive& drive) {
  std::vector<OdometryScan> scans;
  for (int i = 0; i < drive.scans; ++i) scans.push_back(drive.scan(i));
  return scans;
}

double pitch_error_sigma(const Drive& drive, const FusedScan& scan, int index) {
  const Vector6d error = difference(drive.truth(index), scan.odometry_from_vehicle);
  return std::abs(error[4]) / std::sqrt(scan.covariance(4, 4));
}

// Without wheels nothing tells that the vehicle brakes: the accelerometer reads a slope of 17 degrees.
TEST(fusion_faults, braking_without_wheels_does_not_pass_for_a_slope) {
  Drive drive = street_drive();
  drive.yaw_rate_radps = 0.0;
  SensorStreams streams = drive.streams();
  streams.wheels.clear();
  const Eigen::Vector3d braking = drive.mounting.vehicle_from_imu.linear().transpose() * Eigen::Vector3d(-3.0, 0, 0);
  for (motion::ImuSample& sample : streams.imu) sample.specific_force_mps2 += braking;
  const FusionOdometryResult result = solve(drive, scans_of(drive), streams, {});
  for (std::size_t i = 0; i < result.scans.size(); ++i)
    EXPECT_LT(pitch_error_sigma(drive, result.scans[i], static_cast<int>(i)), 3.0) << i;
}

TEST(fusion_faults, after_a_gap_without_wheels_a_new_map_is_begun) {
  Drive drive = street_drive();
  drive.scans = 60;
  std::vector<OdometryScan> scans = scans_of(drive);
  scans.erase(scans.begin() + 10, scans.begin() + 40);  // 24 m; the vehicle may have gone anywhere
  for (std::size_t i = 10; i < scans.size(); ++i)       // and it did: seen from where it is now, all has turned
    for (Eigen::Vector3f& point : scans[i].cloud_in_lidar.points)
      point = so3_exp({0.0, 0.0, 1.3}).cast<float>() * point + Eigen::Vector3f(0.0f, 0.0f, 30.0f);
  drive.mounting.vehicle_from_lidar = RigidTransform::Identity();
  const FusionOdometryResult result = solve(drive, scans, {}, lidar_only());
  int restarts = 0;
  for (const FusedScan& scan : result.scans) restarts += scan.map_restarted ? 1 : 0;
  EXPECT_EQ(restarts, 1);
  for (std::size_t i = 15; i < result.scans.size(); ++i) {
    EXPECT_TRUE(result.scans[i].usable) << i;
    const RigidTransform step =
        result.scans[i - 1].odometry_from_vehicle.inverse() * result.scans[i].odometry_from_vehicle;
    EXPECT_NEAR(step.translation().norm(), 0.8, 0.05) << i;
  }
  EXPECT_GT(std::sqrt(result.scans.back().covariance(0, 0)), 10.0);  // nobody knows how far it went meanwhile
}

TEST(fusion_faults, scans_without_features_push_nothing_out_of_the_map) {
  Drive drive = street_drive();
  drive.scans = 30;
  std::vector<OdometryScan> scans = scans_of(drive);
  for (std::size_t i = 8; i < 25; ++i) scans[i].cloud_in_lidar = {}, scans[i].time_from_stamp_s.clear();
  const FusionOdometryResult result = solve(drive, scans, drive.streams(), {});
  EXPECT_EQ(english(result.scans[24].undetermined), "all");
  EXPECT_EQ(english(result.scans[25].undetermined), "");
  EXPECT_GT(result.scans[25].plane_matches, 100);
}

TEST(fusion_faults, a_steady_error_of_the_accelerometer_is_not_averaged_away) {
  Drive drive = street_drive();
  drive.scans = 60;
  drive.beams = 12;
  FusionOptions options;
  options.accelerometer_bias_deg = 0.3;
  SensorStreams streams = drive.streams();
  const Eigen::Matrix3d imu_from_vehicle = drive.mounting.vehicle_from_imu.linear().transpose();
  const double tilt = 9.81 * degrees_to_radians(0.4);
  for (motion::ImuSample& sample : streams.imu)
    sample.specific_force_mps2 += imu_from_vehicle * Eigen::Vector3d(tilt, 0, 0);
  const FusionOdometryResult result = solve(drive, scans_of(drive), streams, options);
  EXPECT_GT(std::sqrt(result.scans.back().covariance(4, 4)), degrees_to_radians(0.29));
  EXPECT_LT(pitch_error_sigma(drive, result.scans.back(), drive.scans - 1), 2.0);
  options.accelerometer_bias_deg = 0.0;
  const FusedScan unaware = solve(drive, scans_of(drive), streams, options).scans.back();
  std::cout << "    sigma of pitch " << radians_to_degrees(std::sqrt(result.scans.back().covariance(4, 4)))
            << " deg, without its steady part " << radians_to_degrees(std::sqrt(unaware.covariance(4, 4))) << "\n";
  // Six seconds of samples are worth twelve windows of half a second, not sixty.
  EXPECT_GT(std::sqrt(unaware.covariance(4, 4)), degrees_to_radians(0.5 / std::sqrt(15.0)));
}

TEST(fusion_faults, a_steady_error_of_the_barometer_is_not_averaged_away) {
  Drive drive = street_drive();
  drive.scans = 100;
  FusionOptions options;
  options.lines = options.planes = options.accelerometer = false;
  options.sideslip_sigma_mps = 1.0;  // heights rest on the barometer
  options.barometer_drift_m = 2.0;
  const std::vector<OdometryScan> scans = [&] {
    std::vector<OdometryScan> empty;
    for (int i = 0; i < drive.scans; ++i) empty.push_back({Drive::stamp_ns(drive.time_s(i)), {}, {}});
    return empty;
  }();
  const double aware_m = std::sqrt(solve(drive, scans, drive.streams(), options).scans.back().covariance(2, 2));
  options.barometer_drift_m = 0.0;
  const double unaware_m = std::sqrt(solve(drive, scans, drive.streams(), options).scans.back().covariance(2, 2));
  std::cout << "    sigma of height " << aware_m << " m, without its steady part " << unaware_m << " m\n";
  EXPECT_GT(aware_m, 1.0);
  EXPECT_LT(unaware_m, 0.7);
}

TEST(fusion_faults, a_barometer_that_starts_late_still_takes_part) {
  Drive drive = street_drive();
  drive.scans = 20;
  SensorStreams streams = drive.streams();
  std::erase_if(streams.barometer, [&](const motion::BarometerSample& s) { return s.stamp_ns < Drive::stamp_ns(1.0); });
  const FusionOdometryResult result = solve(drive, scans_of(drive), streams, {});
  EXPECT_FALSE(result.scans[5].height_measured);
  EXPECT_TRUE(result.scans.back().height_measured);
  EXPECT_NEAR(result.scans.back().odometry_from_vehicle.translation().z(), 0.0, 0.02);
}

TEST(fusion_faults, without_a_solution_the_covariance_grows_by_the_prediction) {
  StepAnchor anchor;
  anchor.before = make_rigid(so3_exp({0.0, 0.0, kPi / 2}), {3.0, 0.0, 0.0});
  anchor.predicted = make_rigid(anchor.before.linear(), {3.0, 2.0, 0.0});
  StateCovariance before = StateCovariance::Zero();
  before.diagonal() << 0.01, 0.01, 0.01, 1e-4, 1e-4, 1e-4, 1e-8, 1e-8, 1e-8, 1e-6, Eigen::Matrix<double, 8, 1>::Zero();
  const Matrix6d step = step_covariance_of({{0.5, 0.1, 0.2}, {0.01, 0.02, 0.03}}, anchor);
  EXPECT_NEAR(step(1, 1), 0.25, 1e-12);  // ahead is y of the odometry
  const StateCovariance after = grown_covariance(before, anchor, FusionVector::Zero(), step);
  EXPECT_NEAR(after(1, 1), 0.01 + 0.25, 1e-12);
  EXPECT_NEAR(after(0, 0), 0.01 + 0.01 + 1e-4 * 4.0, 1e-12);  // the heading's error over 2 m
  EXPECT_NEAR(after(5, 5), 1e-4 + 9e-4, 1e-12);
  EXPECT_NEAR(after(9, 9), 1e-6, 1e-15);
}

}  // namespace
}  // namespace remount::odometry
