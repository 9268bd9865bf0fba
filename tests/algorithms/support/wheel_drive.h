// A drive over a road with known truth, as wheels, IMU, an INS and a sensor's odometry see it.
#pragma once

#include <cmath>
#include <random>

#include "algorithms/calibration/vehicle_frame/vehicle_frame.h"
#include "tests/algorithms/support/random_motion.h"

namespace remount::testing {

struct WheelDriveOptions {
  double duration_s = 200.0;
  double speed_mps = 10.0;
  double slope_rad = degrees_to_radians(5.0);  ///< amplitude of pitch
  double bank_rad = degrees_to_radians(2.0);   ///< amplitude of roll
  double turn_rad = 1.5;                       ///< amplitude of heading
  double winding_radpm = 0.0;                  ///< heading that grows with the way
  double climb_rad = 0.0;                      ///< slope that does not change; positive: uphill
  double imu_rate_hz = 100.0;
  double sensor_rate_hz = 10.0;
  double track_m = 1.6;
  double scale = 1.0;  ///< metres per unit of the sensor
  bool reference = true;
  // noise; zero: exact
  double rate_noise_radps = 0.0;       ///< of each IMU sample
  double speed_noise_mps = 0.0;        ///< of each wheel sample
  double sensor_way_noise_m = 0.0;     ///< of each step of the sensor's odometry
  double sensor_turn_noise_rad = 0.0;  ///< likewise
  double reference_noise_rad = 0.0;    ///< of each attitude of the reference
  Eigen::Vector3d gyro_bias_radps = Eigen::Vector3d::Zero();
  RigidTransform vehicle_from_sensor = make_rigid(rotation_from_yaw_pitch_roll({0.4, -0.05, 0.08}), {1.3, -0.4, 1.7});
  Eigen::Matrix3d vehicle_from_imu = rotation_from_yaw_pitch_roll({0.03, -0.02, 0.04});
};

/// Attitude along the road, whatever the speed.
inline Eigen::Matrix3d road_attitude(const WheelDriveOptions& options, double way_m) {
  const double yaw =
      options.turn_rad * (std::sin(way_m / 31.0) + 0.4 * std::sin(way_m / 13.0 + 1.0)) + options.winding_radpm * way_m;
  const double pitch = -options.climb_rad + options.slope_rad * std::sin(way_m / 17.0 + 0.3);
  const double roll = options.bank_rad * std::sin(way_m / 11.0 + 2.0);
  return rotation_from_yaw_pitch_roll({yaw, pitch, roll});
}

inline double way_at(const WheelDriveOptions& options, double t) {  // the speed swings by a fifth
  return options.speed_mps * (t + 0.2 * 5.0 * (1.0 - std::cos(t / 5.0)));
}
inline double speed_at(const WheelDriveOptions& options, double t) {
  return options.speed_mps * (1.0 + 0.2 * std::sin(t / 5.0));
}
inline Eigen::Vector3d body_rate(const WheelDriveOptions& options, double t) {
  constexpr double kStep_s = 1e-4;
  const Eigen::Matrix3d before = road_attitude(options, way_at(options, t - kStep_s));
  return so3_log(before.transpose() * road_attitude(options, way_at(options, t + kStep_s))) / (2.0 * kStep_s);
}

/// True poses world_from_vehicle, every `step_s`: the rear axle's centre moves along x of the vehicle alone.
inline std::vector<motion::StampedPose> true_road(const WheelDriveOptions& options, double step_s) {
  constexpr int kParts = 10;
  std::vector<motion::StampedPose> poses;
  Eigen::Vector3d position = Eigen::Vector3d::Zero();
  const auto velocity = [&](double t) {
    return Eigen::Vector3d(speed_at(options, t) * road_attitude(options, way_at(options, t)).col(0));
  };
  const auto count = static_cast<int>(std::lround(options.duration_s / step_s));
  for (int i = 0; i <= count; ++i) {
    const double t = i * step_s, part = step_s / kParts;
    poses.push_back({std::llround(t * 1e9), make_rigid(road_attitude(options, way_at(options, t)), position)});
    for (int k = 0; k < kParts; ++k) {
      const double from = t + k * part;
      position += part / 6.0 * (velocity(from) + 4.0 * velocity(from + 0.5 * part) + velocity(from + part));
    }
  }
  return poses;
}

struct WheelDrive {
  std::vector<motion::ImuSample> imu;
  std::vector<motion::WheelSample> wheels;
  std::vector<motion::StampedPose> world_from_vehicle;  // the truth at the sensor's stamps
  calibration::VehicleDrive drive() const {
    return {motion::WheelImuSignals(imu, wheels), world_from_sensor, reference_from_vehicle};
  }
  std::vector<motion::StampedPose> world_from_sensor, reference_from_vehicle;
};

inline WheelDrive wheel_drive(const WheelDriveOptions& options, int seed = 1) {
  std::mt19937_64 random(static_cast<std::uint64_t>(seed));
  WheelDrive out;
  const auto samples = static_cast<int>(std::lround(options.duration_s * options.imu_rate_hz));
  for (int i = 0; i <= samples; ++i) {
    const double t = i / options.imu_rate_hz;
    const Eigen::Vector3d rate = body_rate(options, t);
    motion::ImuSample imu;
    imu.stamp_ns = std::llround(t * 1e9);
    imu.angular_rate_radps = options.vehicle_from_imu.transpose() * rate + options.gyro_bias_radps +
                             random_vector(random, options.rate_noise_radps);
    imu.specific_force_mps2.setConstant(std::numeric_limits<double>::quiet_NaN());
    out.imu.push_back(imu);
    const Eigen::Vector3d noise = random_vector(random, options.speed_noise_mps);
    out.wheels.push_back({imu.stamp_ns, speed_at(options, t) - 0.5 * options.track_m * rate.z() + noise[0],
                          speed_at(options, t) + 0.5 * options.track_m * rate.z() + noise[1]});
  }
  out.world_from_vehicle = true_road(options, 1.0 / options.sensor_rate_hz);
  RigidTransform odometry = RigidTransform::Identity();
  for (std::size_t i = 0; i < out.world_from_vehicle.size(); ++i) {
    const motion::StampedPose& pose = out.world_from_vehicle[i];
    if (i > 0) {
      const RigidTransform before = out.world_from_vehicle[i - 1].pose * options.vehicle_from_sensor;
      const Vector6d noise = random_step(random, options.sensor_way_noise_m, options.sensor_turn_noise_rad);
      RigidTransform step = perturb(before.inverse() * pose.pose * options.vehicle_from_sensor, noise);
      step.translation() /= options.scale;
      odometry = odometry * step;
    }
    out.world_from_sensor.push_back({pose.stamp_ns, odometry});
    if (options.reference) {
      const Eigen::Matrix3d noise = so3_exp(random_vector(random, options.reference_noise_rad));
      out.reference_from_vehicle.push_back({pose.stamp_ns, make_rigid(pose.pose.linear() * noise, {0, 0, 0})});
    }
  }
  return out;
}

/// What a good vehicle has: a MEMS gyro, wheel encoders, a LiDAR odometry and an INS.
inline WheelDriveOptions noisy_drive() {
  WheelDriveOptions options;
  options.rate_noise_radps = 0.003;
  options.speed_noise_mps = 0.02;
  options.sensor_way_noise_m = 0.003;
  options.sensor_turn_noise_rad = 2e-4;
  options.reference_noise_rad = degrees_to_radians(0.02);
  options.gyro_bias_radps = {0.002, -0.001, 0.003};
  return options;
}

}  // namespace remount::testing
