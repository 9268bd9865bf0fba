#include "algorithms/odometry/fusion/fusion_odometry.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <iostream>

#include "algorithms/core/error.h"
#include "algorithms/messages/render.h"
#include "tests/algorithms/odometry/synthetic_drive.h"
#include "tests/algorithms/support/size_of_error.h"

namespace remount::odometry {
namespace {

using synthetic::Drive;
using synthetic::lidar_only;
using synthetic::street_drive;

struct EndError {
  double shift_m, turn_rad;
};

EndError end_error(const Drive& drive, const FusionOdometryResult& result) {
  const RigidTransform& found = result.scans.back().odometry_from_vehicle;
  const RigidTransform truth = drive.truth(drive.scans - 1);
  const EndError error{(found.translation() - truth.translation()).norm(), rotation_angle_between_rad(found, truth)};
  std::cout << "    end error " << 1000.0 * error.shift_m << " mm, " << radians_to_degrees(error.turn_rad)
            << " deg; last residual " << 1000.0 * result.scans.back().residual_m << " mm, undetermined '"
            << result.scans.back().undetermined << "'\n";
  return error;
}

Drive noisy(Drive drive, std::uint64_t seed) {
  drive.noise = {0.015, 0.02, 0.02, 0.02, 0.002, 0.1};
  drive.seed = seed;
  return drive;
}

TEST(fusion_odometry, exact_sensors_lead_to_the_true_end) {
  const Drive drive = street_drive();
  const FusionOdometryResult result = drive.solve({});
  const EndError error = end_error(drive, result);
  EXPECT_LT(error.shift_m, 0.05);  // 15 m; edges lie where a ray happened to meet them
  EXPECT_LT(error.turn_rad, degrees_to_radians(0.03));
  FusionOptions no_lines;
  no_lines.lines = false;
  EXPECT_LT(end_error(drive, drive.solve(no_lines)).shift_m, 0.005);
  for (const FusedScan& scan : result.scans) EXPECT_TRUE(scan.usable);
  EXPECT_TRUE(result.scans.back().dead_reckoned && result.scans.back().levelled && result.scans.back().height_measured);
  EXPECT_GT(result.scans.back().line_matches, 10);
  EXPECT_GT(result.scans.back().plane_matches, 100);
}

TEST(fusion_odometry, the_lidar_alone_finds_the_way_where_there_is_something_to_see) {
  const Drive drive = street_drive();
  const EndError error = end_error(drive, drive.solve(lidar_only()));
  EXPECT_LT(error.shift_m, 0.05);
  EXPECT_LT(error.turn_rad, degrees_to_radians(0.1));
}

TEST(fusion_odometry, terms_can_be_switched_off_one_by_one) {
  Drive drive = street_drive();
  drive.scans = 8;
  for (bool FusionOptions::*term : {&FusionOptions::lines, &FusionOptions::planes, &FusionOptions::ackermann,
                                    &FusionOptions::accelerometer, &FusionOptions::barometer}) {
    FusionOptions options;
    options.*term = false;
    const FusionOdometryResult result = drive.solve(options);
    EXPECT_LT(end_error(drive, result).shift_m, 0.06);
    const FusedScan& last = result.scans.back();
    EXPECT_EQ(last.line_matches > 0, options.lines);
    EXPECT_EQ(last.plane_matches > 0, options.planes);
    EXPECT_EQ(last.dead_reckoned, options.ackermann);
    EXPECT_EQ(last.levelled, options.accelerometer);
    EXPECT_EQ(last.height_measured, options.barometer);
  }
}

// The error of the end, measured by the covariance that the odometry states: chi-square of six degrees of freedom.
TEST(fusion_odometry, the_covariance_is_honest) {
  constexpr int kDrives = 12;
  double sum = 0.0, widest_m = 0.0, widest_rad = 0.0;
  for (int seed = 1; seed <= kDrives; ++seed) {
    const Drive drive = noisy(street_drive(), static_cast<std::uint64_t>(seed));
    const FusionOdometryResult result = drive.solve({});
    const Vector6d error = difference(drive.truth(drive.scans - 1), result.scans.back().odometry_from_vehicle);
    const double chi2 = testing::squared_over_sigma(error, result.scans.back().covariance);
    std::cout << "    seed " << seed << ": chi2 " << chi2 << ", error " << error.transpose() << ", sigma "
              << result.scans.back().covariance.diagonal().cwiseSqrt().transpose() << "\n";
    sum += chi2;
    const Vector6d sigma = result.scans.back().covariance.diagonal().cwiseSqrt();
    widest_m = std::max(widest_m, sigma.head<3>().maxCoeff());
    widest_rad = std::max(widest_rad, sigma.tail<3>().maxCoeff());
  }
  // 72 degrees of freedom: 1% above 102.8. It is rather too wide than too narrow, since what neighbours in a map have
  // in common is not known; but not so wide that it says nothing. The steady errors of
  // accelerometer and barometer that are assumed are not in these drives: they alone make 0.12 m of height.
  EXPECT_LT(sum, 102.8);
  EXPECT_LT(widest_m, 0.15);
  EXPECT_LT(widest_rad, degrees_to_radians(0.5));
}

TEST(fusion_odometry, runs_through_a_featureless_tunnel_where_the_lidar_alone_slips) {
  Drive drive;
  drive.world = synthetic::tunnel();
  drive.speed_mps = 15.0;
  drive.scans = 200;
  drive.beams = 16;
  drive.azimuths = 360;
  drive = noisy(drive, 4);
  const double length_m = drive.speed_mps * drive.time_s(drive.scans - 1);
  const FusionOdometryResult fused = drive.solve({}), alone = drive.solve(lidar_only());
  EXPECT_LT(end_error(drive, fused).shift_m, 0.005 * length_m);
  EXPECT_GT(end_error(drive, alone).shift_m, 0.05 * length_m);
  for (std::size_t i = 5; i < fused.scans.size(); ++i) {
    EXPECT_FALSE(fused.scans[i].undetermined.empty()) << i;
    EXPECT_FALSE(alone.scans[i].undetermined.empty()) << i;
  }
  EXPECT_EQ(english(fused.scans.back().undetermined), "x (axes of the vehicle)");
  // It is not sure of itself either.
  EXPECT_GT(std::sqrt(alone.scans.back().covariance(0, 0)), 0.1 * end_error(drive, alone).shift_m);
  EXPECT_LT(std::sqrt(fused.scans.back().covariance(0, 0)), 0.02 * length_m);
}

TEST(fusion_odometry, compensation_of_motion_halves_the_residual_of_a_fast_turn) {
  Drive drive = street_drive();
  drive.speed_mps = 4.0;
  drive.yaw_rate_radps = 1.0;
  drive.noise.range_m = 0.01;
  const auto residual_m = [&](bool deskew) {
    FusionOptions options;
    options.deskew = deskew;
    options.lines = false;  // edges lie where a ray happened to meet them, which hides what is asked here
    const FusionOdometryResult result = drive.solve(options);
    double sum = 0.0;
    for (std::size_t i = 5; i < result.scans.size(); ++i) sum += result.scans[i].residual_m;
    end_error(drive, result);
    return sum / static_cast<double>(result.scans.size() - 5);
  };
  const double with_m = residual_m(true), without_m = residual_m(false);
  std::cout << "    rms distance from the map: " << 1000.0 * with_m << " mm, without compensation "
            << 1000.0 * without_m << " mm\n";
  EXPECT_LT(with_m, 0.5 * without_m);
}

TEST(fusion_odometry, learns_the_bias_of_the_gyroscope) {
  Drive drive = noisy(street_drive(), 2);
  drive.noise.gyro_bias_dps = 0.3;
  drive.scans = 40;
  FusionOptions options;
  options.gyro_bias_sigma_dps = 0.3;
  const FusionOdometryResult result = drive.solve(options);
  end_error(drive, result);
  Drive unbiased = drive;
  unbiased.noise.gyro_bias_dps = 0.0;
  const Eigen::Vector3d bias =
      drive.mounting.vehicle_from_imu.linear() *
      (drive.streams().imu.front().angular_rate_radps - unbiased.streams().imu.front().angular_rate_radps);
  const Eigen::Vector3d error = result.drift.gyro_bias_radps - bias;
  EXPECT_GT(bias.norm(), degrees_to_radians(0.1));
  EXPECT_LT(error.norm(), degrees_to_radians(0.06));
  for (int axis = 0; axis < 3; ++axis) EXPECT_LT(std::abs(error[axis]), 4.0 * result.drift_sigma[axis]) << axis;
}

// On a steady slope the accelerometer tells the pitch from the start, and the barometer agrees.
TEST(fusion_odometry, climbs_where_the_road_climbs) {
  Drive drive = noisy(street_drive(), 3);
  drive.world = synthetic::tunnel();
  drive.yaw_rate_radps = 0.0;
  drive.scans = 30;
  SensorStreams streams = drive.streams();
  // A world that climbs by 6%, told by gravity and air pressure alone.
  const Eigen::Matrix3d tilt = rotation_from_yaw_pitch_roll({0.0, -0.06, 0.0}).transpose();
  const RigidTransform& vehicle_from_imu = drive.mounting.vehicle_from_imu;
  for (motion::ImuSample& sample : streams.imu)
    sample.specific_force_mps2 =
        vehicle_from_imu.linear().transpose() * (tilt * (vehicle_from_imu.linear() * sample.specific_force_mps2));
  for (motion::BarometerSample& sample : streams.barometer)
    sample.height_m += std::sin(0.06) * 8.0 * 1e-9 * static_cast<double>(sample.stamp_ns - Drive::kStart_ns);
  Progress progress;
  const auto load = [&](std::size_t i) { return drive.scan(static_cast<int>(i)); };
  const FusionOdometryResult result = solve_fusion_odometry(30, load, drive.mounting, streams, {}, 1, progress);
  const double travelled_m = 8.0 * drive.time_s(29);
  EXPECT_NEAR(result.scans.back().odometry_from_vehicle.translation().z(), std::sin(0.06) * travelled_m, 0.15);
}

TEST(fusion_odometry, does_not_depend_on_the_number_of_threads) {
  Drive drive = noisy(street_drive(), 5);
  drive.scans = 6;
  const FusionOdometryResult one = drive.solve({}, 1), three = drive.solve({}, 3);
  for (std::size_t i = 0; i < one.scans.size(); ++i)
    EXPECT_EQ(one.scans[i].odometry_from_vehicle.matrix(), three.scans[i].odometry_from_vehicle.matrix());
}

TEST(fusion_odometry, an_empty_scan_keeps_the_prediction) {
  Drive drive = street_drive();
  drive.scans = 10;
  Progress progress;
  const auto load = [&](std::size_t i) {
    OdometryScan scan = drive.scan(static_cast<int>(i));
    if (i == 6) scan = {scan.stamp_ns, {}, {}};
    return scan;
  };
  const FusionOdometryResult result = solve_fusion_odometry(10, load, drive.mounting, drive.streams(), {}, 1, progress);
  EXPECT_EQ(english(result.scans[6].undetermined), "all");
  EXPECT_LT(end_error(drive, result).shift_m, 0.02);
}

TEST(fusion_odometry, a_cancelled_drive_says_so) {
  const Drive drive = street_drive();
  std::stop_source stop;
  Progress progress(stop.get_token());
  const auto load = [&](std::size_t i) {
    if (i == 2) stop.request_stop();
    return drive.scan(static_cast<int>(i));
  };
  const FusionOdometryResult result = solve_fusion_odometry(20, load, drive.mounting, drive.streams(), {}, 1, progress);
  EXPECT_TRUE(result.cancelled);
  EXPECT_EQ(result.scans.size(), 3u);
}

TEST(fusion_odometry, refuses_settings_out_of_range_and_scans_out_of_order) {
  FusionOptions options;
  options.plane_sigma_m = 0.0;
  EXPECT_THROW(FusionOdometry({}, {}, options), Error);
  FusionOdometry odometry({}, {}, {});
  odometry.add({5, {}, {}});
  EXPECT_THROW(odometry.add({5, {}, {}}), Error);
}

}  // namespace
}  // namespace remount::odometry
