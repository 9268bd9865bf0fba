// The physics of the simulated sensors: what they report is what the true motion makes them report.
#include "model/simulator/sensor_models.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <set>

#include "model/simulator/body_motion.h"
#include "model/simulator/local_earth.h"
#include "model/simulator/simulator.h"

namespace remount::simulator {
namespace {

using Eigen::Vector3d;

/// Sensors without any error.
SimulationOptions exact_options(ScenarioKind scenario = ScenarioKind::Street) {
  SimulationOptions options;
  options.scenario = scenario;
  options.beams = 1;
  options.ins_position_noise_m = options.ins_attitude_noise_deg = 0.0;
  options.imu = {.rate_hz = 1000.0,
                 .gyro_noise_dps = 0.0,
                 .gyro_bias_dps = 0.0,
                 .gyro_bias_walk_dps = 0.0,
                 .accelerometer_noise_mps2 = 0.0,
                 .accelerometer_bias_mps2 = 0.0,
                 .accelerometer_bias_walk_mps2 = 0.0,
                 .ins_from_imu = rigid_from_six({0.3, -0.4, 0.2, 0.5, -0.3, 0.2})};
  options.gnss.noise_m = options.gnss.vertical_noise_m = 0.0;
  options.wheels.slip = options.wheels.noise_mps = 0.0;
  options.barometer = {10.0, 0.0, 0.0, 0.0};
  return options;
}

double time_s(std::int64_t stamp_ns) { return static_cast<double>(stamp_ns - kDriveStart_ns) * 1e-9; }

/// The vertical at a place of the drive, in its start's ENU.
Vector3d up_at(const SimulationOptions& options, const Vector3d& point_in_enu) {
  return LocalEarth(options).at(point_in_enu).start_enu_from_here_enu.col(2);
}

TEST(sensor_models, a_standing_imu_reads_gravity_and_no_turning) {
  SimulationOptions options = exact_options(ScenarioKind::ParkingRamp);
  options.standstill_s = 5.0;
  const Scene scene(options);
  const SimulatedImu imu = simulate_imu(scene);
  int compared = 0;
  for (const motion::ImuSample& sample : imu.samples) {
    if (time_s(sample.stamp_ns) > 4.9) break;
    const RigidTransform enu_from_imu = scene.enu_from_ins(0.0) * options.imu.ins_from_imu;
    const Vector3d up_in_enu = enu_from_imu.linear() * sample.specific_force_mps2;
    ASSERT_LT((up_in_enu - 9.80665 * up_at(options, enu_from_imu.translation())).norm(), 1e-9);
    ASSERT_LT(sample.angular_rate_radps.norm(), 1e-9);
    ++compared;
  }
  EXPECT_GT(compared, 5000);
  EXPECT_GT((imu.samples[0].specific_force_mps2 - Vector3d(0, 0, 9.80665)).norm(), 0.5) << "the IMU is mounted tilted";
}

/// Strapdown integration by trapezia from the first sample to the last; returns the error of position (m), velocity
/// (m/s) and attitude (rad) against the truth.
Vector3d integration_error(const SimulationOptions& options) {
  const Scene scene(options);
  const std::vector<motion::ImuSample> imu = simulate_imu(scene).samples;
  const RigidTransform vehicle_from_imu = scene.vehicle_from_ins() * options.imu.ins_from_imu;
  const auto truth = [&](std::int64_t stamp_ns) { return body_motion(scene, vehicle_from_imu, time_s(stamp_ns)); };
  const Eigen::Matrix3d enu_from_road = scene.enu_from_road().linear();
  BodyMotion now = truth(imu.front().stamp_ns);
  RigidTransform road_from_imu = now.road_from_body;
  Vector3d velocity = now.velocity_in_road_mps;
  for (std::size_t i = 1; i < imu.size(); ++i) {
    const double step_s = static_cast<double>(imu[i].stamp_ns - imu[i - 1].stamp_ns) * 1e-9;
    const Vector3d gravity =
        -9.80665 * enu_from_road.transpose() * up_at(options, enu_from_road * road_from_imu.translation());
    const Vector3d before = road_from_imu.linear() * imu[i - 1].specific_force_mps2 + gravity;
    road_from_imu.linear() =
        road_from_imu.linear() * so3_exp(0.5 * step_s * (imu[i - 1].angular_rate_radps + imu[i].angular_rate_radps));
    const Vector3d after = road_from_imu.linear() * imu[i].specific_force_mps2 + gravity;
    road_from_imu.translation() += step_s * velocity + step_s * step_s * (before / 3.0 + after / 6.0);
    velocity += 0.5 * step_s * (before + after);
  }
  const BodyMotion end = truth(imu.back().stamp_ns);
  return {(road_from_imu.translation() - end.road_from_body.translation()).norm(),
          (velocity - end.velocity_in_road_mps).norm(), rotation_angle_between_rad(road_from_imu, end.road_from_body)};
}

TEST(sensor_models, integrating_a_perfect_imu_returns_to_the_truth) {
  for (const ScenarioKind scenario :
       {ScenarioKind::Street, ScenarioKind::Straight, ScenarioKind::FigureEight, ScenarioKind::ParkingRamp,
        ScenarioKind::Hill, ScenarioKind::Tunnel, ScenarioKind::SlewYard}) {
    SimulationOptions options = exact_options(scenario);
    options.standstill_s = scenario == ScenarioKind::Street ? 2.0 : 0.0;
    options.speed_swing = scenario == ScenarioKind::Straight ? 0.5 : 0.0;
    const Vector3d error = integration_error(options);
    SCOPED_TRACE("scenario " + std::to_string(static_cast<int>(scenario)));
    EXPECT_LT(error[0], 1e-3) << "m";
    EXPECT_LT(error[1], 1e-4) << "m/s";
    EXPECT_LT(error[2], 1e-5) << "rad";
    RecordProperty("m, m/s, rad of " + std::to_string(static_cast<int>(scenario)),
                   std::to_string(error[0]) + ", " + std::to_string(error[1]) + ", " + std::to_string(error[2]));
  }
}

TEST(sensor_models, imu_errors_are_the_stated_ones) {
  SimulationOptions options = exact_options(ScenarioKind::Straight);
  options.duration_s = 120.0;
  options.imu.rate_hz = 50.0;
  const std::vector<motion::ImuSample> exact = simulate_imu(Scene(options)).samples;
  options.imu.gyro_noise_dps = 0.05;
  options.imu.gyro_bias_dps = 0.3;
  options.imu.accelerometer_noise_mps2 = 0.02;
  options.imu.accelerometer_bias_mps2 = 0.1;
  options.imu.gyro_bias_walk_dps = 0.001;
  options.imu.accelerometer_bias_walk_mps2 = 0.001;
  const double n = 3.0 * static_cast<double>(exact.size());
  double gyro2 = 0.0, accelerometer2 = 0.0;
  Vector3d gyro_end2 = Vector3d::Zero();
  constexpr int kSeeds = 30;
  for (options.seed = 1; options.seed <= kSeeds; ++options.seed) {
    const SimulatedImu imu = simulate_imu(Scene(options));
    ASSERT_EQ(imu.samples.size(), exact.size());
    for (std::size_t i = 0; i < exact.size(); ++i) {
      gyro2 += (imu.samples[i].angular_rate_radps - exact[i].angular_rate_radps - imu.errors[i].gyro_bias_radps)
                   .squaredNorm() /
               n / kSeeds;
      accelerometer2 +=
          (imu.samples[i].specific_force_mps2 - exact[i].specific_force_mps2 - imu.errors[i].accelerometer_bias_mps2)
              .squaredNorm() /
          n / kSeeds;
    }
    gyro_end2 += (imu.errors.back().gyro_bias_radps - imu.errors.front().gyro_bias_radps).cwiseAbs2() / kSeeds;
  }
  EXPECT_NEAR(radians_to_degrees(std::sqrt(gyro2)), 0.05, 0.0005);
  EXPECT_NEAR(std::sqrt(accelerometer2), 0.02, 0.0002);
  // Of 90 numbers: 7 % of sigma, three times over.
  EXPECT_NEAR(radians_to_degrees(std::sqrt(gyro_end2.mean())), 0.001 * std::sqrt(121.0), 0.22 * 0.011);
}

TEST(sensor_models, wheels_integrate_to_the_driven_distance_and_the_turned_angle) {
  for (const ScenarioKind scenario : {ScenarioKind::Flat, ScenarioKind::Street}) {
    SimulationOptions options = exact_options(scenario);
    options.wheels.rate_hz = 200.0;
    options.speed_swing = 0.3;
    const Scene scene(options);
    const std::vector<motion::WheelSample> wheels = simulate_wheels(scene);
    double distance_m = 0.0, turned_rad = 0.0;
    for (std::size_t i = 1; i < wheels.size(); ++i) {
      const double step_s = static_cast<double>(wheels[i].stamp_ns - wheels[i - 1].stamp_ns) * 1e-9;
      const auto mean = [&](auto member) { return 0.5 * step_s * (wheels[i].*member + wheels[i - 1].*member); };
      const double left_m = mean(&motion::WheelSample::rear_left_mps),
                   right_m = mean(&motion::WheelSample::rear_right_mps);
      distance_m += 0.5 * (left_m + right_m);
      turned_rad += (right_m - left_m) / kTrack_m;
    }
    const double first_s = time_s(wheels.front().stamp_ns), last_s = time_s(wheels.back().stamp_ns);
    double truly_m = 0.0;
    for (double t = first_s; t < last_s - 1e-6; t += 1e-3)
      truly_m += (scene.road_from_vehicle(t + 1e-3).translation() - scene.road_from_vehicle(t).translation()).norm();
    const auto yaw = [&](double t) {
      return yaw_pitch_roll_from_rotation(scene.road_from_vehicle(t).linear()).yaw_rad;
    };
    // On slopes wheels run along the body's x axis, which is not quite the direction of travel; and turning about the
    // body's axis is not quite turning of the heading.
    const bool flat = scenario == ScenarioKind::Flat;
    EXPECT_NEAR(distance_m, truly_m, flat ? 1e-3 : 2e-3 * truly_m);
    EXPECT_NEAR(turned_rad, wrap_angle_rad(yaw(last_s) - yaw(first_s)), flat ? 1e-4 : 0.02);
    EXPECT_GT(truly_m, 50.0);
  }
}

TEST(sensor_models, wheels_have_the_stated_scale_and_slip) {
  SimulationOptions options = exact_options(ScenarioKind::Straight);
  options.duration_s = 100.0;
  options.wheels = {100.0, 1.02, 0.97, 0.01, 0.02};
  double left = 0.0, right = 0.0, left2 = 0.0;
  const std::vector<motion::WheelSample> wheels = simulate_wheels(Scene(options));
  const double n = static_cast<double>(wheels.size());
  for (const motion::WheelSample& sample : wheels) {
    left += sample.rear_left_mps / n;
    right += sample.rear_right_mps / n;
    left2 += std::pow(sample.rear_left_mps - 6.0 * 1.02, 2) / n;
  }
  EXPECT_NEAR(left / 6.0, 1.02, 5e-4);
  EXPECT_NEAR(right / 6.0, 0.97, 5e-4);
  EXPECT_NEAR(std::sqrt(left2), std::hypot(0.02, 0.01 * 6.12), 0.002);
}

TEST(sensor_models, lasting_slip_has_the_stated_spread_and_dies_away_as_stated) {
  SimulationOptions options = exact_options(ScenarioKind::Straight);
  options.duration_s = 2000.0;
  options.wheels.rate_hz = 20.0;
  options.wheels.lasting_slip = 0.02;
  options.wheels.lasting_slip_s = 4.0;
  const std::vector<motion::WheelSample> wheels = simulate_wheels(Scene(options));
  std::vector<double> left, right;
  for (const motion::WheelSample& sample : wheels) {
    left.push_back(sample.rear_left_mps / options.speed_mps - 1.0);
    right.push_back(sample.rear_right_mps / options.speed_mps - 1.0);
  }
  const auto mean_product = [](const std::vector<double>& a, const std::vector<double>& b, std::size_t lag) {
    double sum = 0.0;
    for (std::size_t i = lag; i < a.size(); ++i) sum += a[i] * b[i - lag];
    return sum / static_cast<double>(a.size() - lag);
  };
  const double power = mean_product(left, left, 0);
  const double after_4_s = mean_product(left, left, 80) / power, across = mean_product(left, right, 0) / power;
  std::printf("  sigma %.4f, correlation after 4 s %.3f, of the wheels %.3f\n", std::sqrt(power), after_4_s, across);
  // Some 250 independent values: three sigma of their estimates.
  EXPECT_NEAR(std::sqrt(power), 0.02, 0.003);
  EXPECT_NEAR(after_4_s, std::exp(-1.0), 0.2);
  EXPECT_NEAR(across, 0.0, 0.2);
}

TEST(sensor_models, gnss_is_the_antenna_with_the_stated_covariance_outliers_and_outage) {
  SimulationOptions options = exact_options();
  options.duration_s = 400.0;
  options.gnss.rate_hz = 20.0;
  const auto exact = simulate_gnss(Scene(options)).fixes;
  const Scene scene(options);
  const Vector3d antenna = scene.enu_from_ins(time_s(exact[777].stamp_ns)) * options.gnss.antenna_in_ins_m;
  EXPECT_NEAR(LocalEarth(options).at(antenna).latitude_rad, exact[777].latitude_rad, 1e-15);
  EXPECT_NEAR(LocalEarth(options).at(antenna).height_m, exact[777].height_m, 1e-9);

  options.gnss.noise_m = 0.05;
  options.gnss.vertical_noise_m = 0.1;
  options.gnss.outlier_share = 0.2;
  options.gnss.outlier_m = 5.0;
  options.gnss.outage_start_s = 100.0;
  options.gnss.outage_s = 30.0;
  const SimulatedGnss gnss = simulate_gnss(Scene(options));
  const std::set<std::int64_t> outliers(gnss.outlier_stamps_ns.begin(), gnss.outlier_stamps_ns.end());
  EXPECT_EQ(gnss.fixes.size(), exact.size() - 600);
  Vector3d square = Vector3d::Zero();
  std::size_t other = 0, good = 0;
  for (const motion::GnssFix& fix : gnss.fixes) {
    while (exact[other].stamp_ns != fix.stamp_ns) ++other;
    EXPECT_TRUE(time_s(fix.stamp_ns) < 100.0 || time_s(fix.stamp_ns) > 129.9);
    constexpr double kRadius_m = 6.38e6;  // good to half a percent
    const Vector3d off((fix.longitude_rad - exact[other].longitude_rad) * kRadius_m * std::cos(fix.latitude_rad),
                       (fix.latitude_rad - exact[other].latitude_rad) * kRadius_m,
                       fix.height_m - exact[other].height_m);
    if (outliers.count(fix.stamp_ns)) {
      EXPECT_GT(off.norm(), 4.5);
      EXPECT_LT(off.norm(), 10.5);
      continue;
    }
    square += off.cwiseAbs2();
    ++good;
  }
  EXPECT_NEAR(1.0 - static_cast<double>(good) / static_cast<double>(gnss.fixes.size()), 0.2, 0.015);
  const Vector3d ratio = (square / static_cast<double>(good)).cwiseQuotient(gnss.fixes[0].covariance_enu_m2.diagonal());
  EXPECT_LT((ratio - Vector3d::Ones()).cwiseAbs().maxCoeff(), 0.07) << ratio.transpose();
}

TEST(sensor_models, a_barometer_reads_the_height_but_for_its_offset_noise_and_drift) {
  SimulationOptions options = exact_options(ScenarioKind::ParkingRamp);
  options.duration_s = 100.0;
  const auto exact = simulate_barometer(Scene(options));
  const std::vector<motion::InsSample> ins = simulate_drive(options).session.ins;
  for (std::size_t i = 0; i < exact.size(); ++i) {
    ASSERT_EQ(exact[i].stamp_ns, ins[10 * i].stamp_ns);
    ASSERT_NEAR(exact[i].height_m, ins[10 * i].height_m, 1e-9);
  }
  options.barometer = {10.0, -7.0, 0.0, 0.3};
  double mean = 0.0, square = 0.0;
  const auto noisy = simulate_barometer(Scene(options));
  const double n = static_cast<double>(noisy.size());
  for (std::size_t i = 0; i < noisy.size(); ++i) {
    const double error_m = noisy[i].height_m - exact[i].height_m;
    mean += error_m / n;
    square += std::pow(error_m + 7.0, 2) / n;
  }
  EXPECT_NEAR(mean, -7.0, 0.04);
  EXPECT_NEAR(std::sqrt(square), 0.3, 0.03);
  options.barometer = {10.0, 0.0, 0.2, 0.0};
  double end2 = 0.0;
  for (options.seed = 1; options.seed <= 40; ++options.seed)
    end2 += std::pow(simulate_barometer(Scene(options)).back().height_m - exact.back().height_m, 2) / 40.0;
  EXPECT_NEAR(std::sqrt(end2), 0.2 * std::sqrt(101.0), 0.7) << "the ground of other seeds differs by decimetres";
}

TEST(sensor_models, a_degraded_ins_drifts_by_what_it_states_and_a_gap_has_no_samples) {
  SimulationOptions options = exact_options(ScenarioKind::Flat);
  options.duration_s = 30.0;
  const auto exact = simulate_drive(options).session.ins;
  options.ins_position_noise_m = 0.01;
  options.ins_trouble = {5.0, 10.0, 0.1, 20.0, 2.0};
  double chi2 = 0.0;
  constexpr int kSeeds = 60;
  for (options.seed = 1; options.seed <= kSeeds; ++options.seed) {
    const auto ins = simulate_drive(options).session.ins;
    EXPECT_EQ(ins.size(), exact.size() - 200);
    EXPECT_EQ(ins[300].quality, motion::InsQuality::Good);
    EXPECT_NEAR(ins[300].sigma.position_enu_m.z(), 0.01, 1e-12);
    const motion::InsSample& worst = ins[1549];
    ASSERT_EQ(worst.stamp_ns, exact[1549].stamp_ns);
    EXPECT_EQ(worst.quality, motion::InsQuality::Degraded);
    EXPECT_NEAR(worst.sigma.position_enu_m.z(), 1.0, 0.01);
    chi2 += std::pow((worst.height_m - exact[1549].height_m) / worst.sigma.position_enu_m.z(), 2) / kSeeds;
    EXPECT_EQ(ins[1560].quality, motion::InsQuality::Good);
    EXPECT_LT(std::abs(ins[1560].height_m - exact[1560].height_m), 0.06);
  }
  EXPECT_NEAR(chi2, 1.0, 0.55) << "three sigma of a mean of 60";
}

TEST(sensor_models, one_sensor_more_or_less_changes_no_other) {
  const SimulatedDrive all = simulate_drive({});
  SimulationOptions options;
  options.imu.rate_hz = options.wheels.rate_hz = options.barometer.rate_hz = 0.0;
  const SimulatedDrive some = simulate_drive(options);
  EXPECT_TRUE(some.session.imu.empty() && some.session.wheels.empty() && some.session.barometer.empty());
  EXPECT_EQ(all.session.imu.size(), 1301u);
  ASSERT_EQ(all.session.gnss.size(), some.session.gnss.size());
  for (std::size_t i = 0; i < all.session.gnss.size(); ++i)
    ASSERT_EQ(all.session.gnss[i].latitude_rad, some.session.gnss[i].latitude_rad);
  ASSERT_EQ(all.session.ins.size(), some.session.ins.size());
  for (std::size_t i = 0; i < all.session.ins.size(); ++i)
    ASSERT_EQ(all.session.ins[i].height_m, some.session.ins[i].height_m);
  EXPECT_EQ(all.session.scans->load(3).points, some.session.scans->load(3).points);
}

}  // namespace
}  // namespace remount::simulator
