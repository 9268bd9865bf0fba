// An excavator with known truth as its three recordings show it: ground, swept arm, full turn.
#pragma once

#include <cmath>
#include <random>

#include "algorithms/calibration/slew/slew.h"
#include "tests/algorithms/support/random_motion.h"

namespace remount::testing {

struct YardTruth {
  RigidTransform machine_from_lidar =
      make_rigid(rotation_from_yaw_pitch_roll({0.12, 0.25, -0.06}), {1.1, -0.9, 0.0});  // origin: at the LiDAR's height
  double ground_m = 2.8;         ///< below the LiDAR's circle, on the slew axis
  double ground_tilt_rad = 0.0;  ///< of the ground against the slew axis, about x of the machine
  double turn_rad = 2.0 * kPi;
  int poses = 150;
  double point_noise_m = 0.0, way_noise_m = 0.0, turn_noise_rad = 0.0;
  bool arm = true;
  double arm_lean_rad = 0.0;
  int points = 3000;
};

inline calibration::SlewData slew_yard(const YardTruth& options, int seed = 1) {
  std::mt19937_64 random(static_cast<std::uint64_t>(seed));
  std::uniform_real_distribution<double> even(0.0, 1.0);
  const RigidTransform lidar_from_machine = options.machine_from_lidar.inverse();
  calibration::SlewData data;
  const Eigen::Matrix3d tilt = so3_exp(options.ground_tilt_rad * Eigen::Vector3d::UnitX());
  for (int i = 0; i < options.points; ++i) {
    const double range = 3.0 + 11.0 * even(random), angle = 2.0 * kPi * even(random);
    const Eigen::Vector3d ground(range * std::cos(angle), range * std::sin(angle), 0.0);
    const Eigen::Vector3d in_machine = tilt * ground - options.ground_m * Eigen::Vector3d::UnitZ();
    data.ground_points.push_back(lidar_from_machine * in_machine + random_vector(random, options.point_noise_m));
    if (!options.arm) continue;
    // The side of the boom that the LiDAR sees, swept through a sector of its plane.
    const double reach = 1.5 + 5.5 * even(random), swing = -0.6 + 1.4 * even(random);
    const Eigen::Vector3d boom(reach * std::cos(swing), -0.3, reach * std::sin(swing));
    const Eigen::Matrix3d lean = so3_exp(options.arm_lean_rad * Eigen::Vector3d::UnitX());
    data.arm_points.push_back(lidar_from_machine * (lean * boom) + random_vector(random, options.point_noise_m));
  }
  // A few points of something else that moved.
  for (int i = 0; options.arm && i < options.points / 20; ++i)
    data.arm_points.push_back(lidar_from_machine * Eigen::Vector3d(4.0, 2.0, -1.0) + random_vector(random, 1.0));
  for (int i = 0; i < options.poses; ++i) {
    const double angle = options.turn_rad * i / options.poses;
    const RigidTransform turned = make_rigid(so3_exp(angle * Eigen::Vector3d::UnitZ()), Eigen::Vector3d::Zero());
    data.first_from_lidar.push_back(
        perturb(lidar_from_machine * turned * options.machine_from_lidar,
                i > 0 ? random_step(random, options.way_noise_m, options.turn_noise_rad) : Vector6d(Vector6d::Zero())));
  }
  return data;
}

/// A LiDAR of 2 cm range noise whose scans are aligned to some millimetres, as slew_turn_test.cpp measures.
inline YardTruth noisy_yard() {
  YardTruth options;
  options.point_noise_m = 0.02;
  options.way_noise_m = 0.003;
  options.turn_noise_rad = 5e-4;
  return options;
}

}  // namespace remount::testing
