// Where one LiDAR sits as another sees it.
#pragma once

#include "algorithms/calibration/parameter.h"
#include "algorithms/motion/pair.h"

namespace remount::calibration {

struct RelativeMounting {
  motion::LidarIndex lidar_a, lidar_b;
  RigidTransform lidar_a_from_lidar_b = RigidTransform::Identity();
  Matrix6d covariance = Matrix6d::Zero();  ///< of its parameters (row_of), m and rad
  ParameterSet observed;                   ///< with a sigma below the options' limits
  double height_m = 0.0;                   ///< of b above a, along z of the INS
  double height_sigma_m = 0.0;             ///< 1-sigma; may be small where neither height is known
};

/// X_a^-1 X_b.
RigidTransform relative_mounting(const RigidTransform& ins_from_lidar_a, const RigidTransform& ins_from_lidar_b);

/// How it moves, under `perturb`, with X_a (first six columns) and X_b.
Eigen::Matrix<double, 6, 12> relative_jacobian(const RigidTransform& ins_from_lidar_a,
                                               const RigidTransform& ins_from_lidar_b);

/// @param covariance of [X_a; X_b] under `perturb` @param limits of sigma that count as observed (observation_limits)
RelativeMounting describe_relative(const RigidTransform& ins_from_lidar_a, const RigidTransform& ins_from_lidar_b,
                                   const Eigen::Matrix<double, 12, 12>& covariance, const Vector6d& limits);

}  // namespace remount::calibration
