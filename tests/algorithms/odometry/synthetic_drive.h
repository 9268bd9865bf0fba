// A vehicle with LiDAR, wheels, IMU and barometer in a world of walls and poles: small, exact, and independent of the
// simulator of the product.
#pragma once

#include <cmath>
#include <functional>
#include <random>
#include <vector>

#include "algorithms/odometry/fusion/fusion_odometry.h"

namespace remount::odometry::synthetic {

/// A rectangle (or, with infinite half sizes, a plane) and an upright pole.
struct Wall {
  Eigen::Vector3d centre, normal, along;
  double half_along_m = 1e9, half_across_m = 1e9;
};
struct Pole {
  Eigen::Vector2d centre;
  double radius_m = 0.15;
};
struct World {
  std::vector<Wall> walls;
  std::vector<Pole> poles;

  double range_m(const Eigen::Vector3d& from, const Eigen::Vector3d& ray) const {
    double nearest = 1e9;
    for (const Wall& wall : walls) {
      const double facing = wall.normal.dot(ray);
      if (std::abs(facing) < 1e-9) continue;
      const double range = wall.normal.dot(wall.centre - from) / facing;
      if (range < 0.5 || range >= nearest) continue;
      const Eigen::Vector3d at = from + range * ray - wall.centre;
      if (std::abs(at.dot(wall.along)) < wall.half_along_m &&
          std::abs(at.dot(wall.normal.cross(wall.along))) < wall.half_across_m)
        nearest = range;
    }
    for (const Pole& pole : poles) {
      const Eigen::Vector2d to = pole.centre - from.head<2>(), level = ray.head<2>();
      const double along = to.dot(level) / level.squaredNorm();
      const double off2 = (to - along * level).squaredNorm();
      if (along < 0.0 || off2 > pole.radius_m * pole.radius_m) continue;
      const double range = along - std::sqrt((pole.radius_m * pole.radius_m - off2) / level.squaredNorm());
      if (range > 0.5 && range < nearest) nearest = range;
    }
    return nearest;
  }
};

inline Wall facade(double x, double y, double normal_yaw, double half_along_m) {
  const Eigen::Vector3d normal(std::cos(normal_yaw), std::sin(normal_yaw), 0.0);
  return {{x, y, 5.0}, normal, Eigen::Vector3d::UnitZ().cross(normal), half_along_m, 8.0};
}

/// Ground, facades that stand at different distances and angles, poles.
inline World street() {
  World world;
  world.walls.push_back({Eigen::Vector3d::Zero(), Eigen::Vector3d::UnitZ(), Eigen::Vector3d::UnitX()});
  for (int i = -6; i < 12; ++i) {
    const double x = 15.0 * i;
    world.walls.push_back(facade(x, 11.0 + (i % 3 + 3) % 3, -kPi / 2 + 0.04 * (i % 4), 5.5));
    world.walls.push_back(facade(x + 4.0, -12.0 - (i % 2 + 2) % 2, kPi / 2 + 0.05 * (i % 3), 4.5));
    world.walls.push_back(facade(x + 7.0, 14.5, 0.1, 3.0));
    world.walls.push_back(facade(x + 10.0, -15.0, kPi + 0.1, 3.0));
    world.poles.push_back({{x + 2.0, 6.0}});
    world.poles.push_back({{x - 5.0, -6.5}});
  }
  return world;
}

/// Four smooth planes along x.
inline World tunnel() {
  World world;
  for (const auto& [centre, normal] : {std::pair<Eigen::Vector3d, Eigen::Vector3d>{{0, 0, 0}, {0, 0, 1}},
                                       {{0, 0, 6}, {0, 0, -1}},
                                       {{0, 5, 0}, {0, -1, 0}},
                                       {{0, -4, 0}, {0, 1, 0}}})
    world.walls.push_back({centre, normal, Eigen::Vector3d::UnitX()});
  return world;
}

struct Noise {
  // Of each sample.
  double range_m = 0.0, gyro_dps = 0.0, gyro_bias_dps = 0.0, force_mps2 = 0.0, wheel_share = 0.0, barometer_m = 0.0;
  // That stay over the drive, or walk.
  double gyro_walk_dps = 0.0, force_bias_mps2 = 0.0, wheel_scale = 0.0, barometer_bias_m = 0.0;
};

struct Drive {
  World world;
  double speed_mps = 8.0;
  double yaw_rate_radps = 0.0;
  double slope_rad = 0.0;  ///< uphill
  int scans = 20;
  int beams = 24, azimuths = 500;
  double max_range_m = 60.0;
  bool distorted = true;  ///< points are taken while the vehicle moves
  Noise noise;
  std::uint64_t seed = 1;
  FusionMounting mounting{make_rigid(so3_exp({0.02, -0.01, 0.3}), {1.2, 0.1, 1.9}),
                          make_rigid(so3_exp({0.01, 0.02, -0.1}), {0.6, -0.2, 0.8})};

  static constexpr double kPeriod_s = 0.1;
  static constexpr std::int64_t kStart_ns = 1700000000000000000;

  double time_s(int scan) const { return kPeriod_s * scan; }
  static std::int64_t stamp_ns(double time_s) { return kStart_ns + std::llround(time_s * 1e9); }

  /// A steady turn on a slope: pitch is negative uphill. The slope turns with the vehicle.
  RigidTransform world_from_vehicle(double time_s) const {
    const Eigen::Vector3d turn(0.0, 0.0, yaw_rate_radps * time_s);
    const Eigen::Vector3d level = so3_left_jacobian(turn).col(0) * speed_mps * std::cos(slope_rad) * time_s;
    return make_rigid(rotation_from_yaw_pitch_roll({turn.z(), -slope_rad, 0.0}),
                      {level.x(), level.y(), std::sin(slope_rad) * speed_mps * time_s});
  }

  OdometryScan scan(int index) const {
    std::mt19937_64 random(seed * 1000003 + static_cast<std::uint64_t>(index));
    std::normal_distribution<double> normal;
    OdometryScan result;
    result.stamp_ns = stamp_ns(time_s(index));
    for (int a = 0; a < azimuths; ++a) {
      const double within_s = kPeriod_s * (static_cast<double>(a) / azimuths - 0.5);
      const RigidTransform pose =
          world_from_vehicle(time_s(index) + (distorted ? within_s : 0.0)) * mounting.vehicle_from_lidar;
      for (int b = 0; b < beams; ++b) {
        const double azimuth = -2.0 * kPi * a / azimuths, elevation = degrees_to_radians(-24.0 + 34.0 * b / beams);
        const Eigen::Vector3d ray(std::cos(elevation) * std::cos(azimuth), std::cos(elevation) * std::sin(azimuth),
                                  std::sin(elevation));
        const double range = world.range_m(pose.translation(), pose.linear() * ray);
        const double measured = range + noise.range_m * normal(random);
        if (range > max_range_m) continue;
        result.cloud_in_lidar.points.push_back((measured * ray).cast<float>());
        result.cloud_in_lidar.ring.push_back(static_cast<std::uint16_t>(b));
        if (distorted) result.time_from_stamp_s.push_back(static_cast<float>(within_s));
      }
    }
    return result;
  }

  SensorStreams streams() const {
    std::mt19937_64 random(seed * 7919 + 17);
    std::normal_distribution<double> normal;
    const auto noisy = [&](double sigma) {
      return Eigen::Vector3d(sigma * normal(random), sigma * normal(random), sigma * normal(random));
    };
    SensorStreams streams;
    const Eigen::Vector3d bias = noisy(degrees_to_radians(noise.gyro_bias_dps));
    std::mt19937_64 lasting(seed * 104729 + 5);
    const double scale = 1.0 + noise.wheel_scale * normal(lasting);
    const Eigen::Vector3d force_bias = noise.force_bias_mps2 * Eigen::Vector3d(normal(lasting), normal(lasting), 0.0);
    const double barometer_bias = noise.barometer_bias_m * normal(lasting);
    Eigen::Vector3d walk = Eigen::Vector3d::Zero();
    const Eigen::Matrix3d imu_from_vehicle = mounting.vehicle_from_imu.linear().transpose();
    for (int i = -20; i <= 10 * scans + 20; ++i) {
      const double t = 0.01 * i;
      const Eigen::Matrix3d vehicle_from_world = world_from_vehicle(t).linear().transpose();
      const Eigen::Vector3d rate = vehicle_from_world * Eigen::Vector3d(0.0, 0.0, yaw_rate_radps);
      const Eigen::Vector3d arm = mounting.vehicle_from_imu.translation(), velocity(speed_mps, 0.0, 0.0);
      const Eigen::Vector3d force =
          vehicle_from_world * Eigen::Vector3d(0.0, 0.0, 9.81) + rate.cross(velocity) + rate.cross(rate.cross(arm));
      streams.imu.push_back({stamp_ns(t),
                             imu_from_vehicle * (rate + bias + walk) + noisy(degrees_to_radians(noise.gyro_dps)),
                             imu_from_vehicle * (force + force_bias) + noisy(noise.force_mps2)});
      for (int axis = 0; axis < 3; ++axis)
        walk[axis] += 0.1 * degrees_to_radians(noise.gyro_walk_dps) * normal(lasting);  // root of the 0.01 s
      const double speed = speed_mps / scale * (1.0 + noise.wheel_share * normal(random));
      if (i % 2 == 0)
        streams.wheels.push_back({stamp_ns(t), speed - 0.8 * yaw_rate_radps, speed + 0.8 * yaw_rate_radps});
      if (i % 10 == 0)
        streams.barometer.push_back({stamp_ns(t), 312.0 + (i > 30 ? barometer_bias : 0.0) +
                                                      world_from_vehicle(t).translation().z() +
                                                      noise.barometer_m * normal(random)});
    }
    return streams;
  }

  FusionOdometryResult solve(const FusionOptions& options, int threads = 1) const {
    Progress progress;
    return solve_fusion_odometry(
        static_cast<std::size_t>(scans), [this](std::size_t i) { return scan(static_cast<int>(i)); }, mounting,
        streams(), options, threads, progress);
  }

  /// The true pose of a scan in the odometry frame: level, with origin and heading of the first scan's vehicle.
  RigidTransform truth(int scan) const { return world_from_vehicle(time_s(scan)); }
};

inline FusionOptions lidar_only() {
  FusionOptions options;
  options.ackermann = options.accelerometer = options.barometer = false;
  return options;
}

/// A slow turn in a street.
inline Drive street_drive() {
  Drive drive;
  drive.world = street();
  drive.yaw_rate_radps = 0.05;
  return drive;
}

}  // namespace remount::odometry::synthetic
