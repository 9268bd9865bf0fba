// Poses of a LiDAR as an odometry gives them: from scan to scan, with errors.
#pragma once

#include <random>
#include <vector>

#include "model/simulator/simulator.h"
#include "tests/algorithms/support/random_motion.h"

namespace remount::testing {

/// odometry_from_lidar at the scans of a drive: errors of `way_m` and `turn_rad` a step, in units of `scale` metres.
inline std::vector<motion::StampedPose> noisy_odometry(const simulator::SimulatedDrive& drive, double way_m,
                                                       double turn_rad, std::uint64_t seed, double scale = 1.0) {
  std::mt19937_64 random(seed);
  std::vector<motion::StampedPose> poses;
  RigidTransform odometry_from_lidar = RigidTransform::Identity();
  for (std::size_t i = 0; i < drive.enu_from_ins.size(); ++i) {
    const RigidTransform enu_from_lidar = drive.enu_from_ins[i].pose * drive.ins_from_lidar;
    if (i > 0) {
      const RigidTransform enu_from_before = drive.enu_from_ins[i - 1].pose * drive.ins_from_lidar;
      RigidTransform step = perturb(enu_from_before.inverse() * enu_from_lidar, random_step(random, way_m, turn_rad));
      step.translation() /= scale;
      odometry_from_lidar = odometry_from_lidar * step;
    }
    poses.push_back({drive.enu_from_ins[i].stamp_ns, odometry_from_lidar});
  }
  return poses;
}

}  // namespace remount::testing
