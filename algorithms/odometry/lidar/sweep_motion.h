// How a sensor moves while it takes one scan.
#pragma once

#include <span>

#include "algorithms/geometry/rigid_transform.h"

namespace remount::odometry {

/// Where the sensor was at a time, seen from where it was at the stamp of a scan.
struct TimedMotion {
  double time_from_stamp_s = 0.0;  ///< not 0
  RigidTransform lidar_at_stamp_from_lidar_at = RigidTransform::Identity();
};

/// Motion as a twist in LiDAR axes, [m; rad], of second order in time: exact for a constant speed on a circle, and it
/// follows what speed and rate of turn change by.
struct SweepMotion {
  Vector6d velocity = Vector6d::Zero();           ///< at the stamp, per s
  Vector6d half_acceleration = Vector6d::Zero();  ///< per s^2

  /// lidar frame at the stamp <- lidar frame at a time, in s from the stamp.
  RigidTransform at(double time_from_stamp_s) const;

  /// Through up to two other poses: none gives rest, one a constant velocity. More are not looked at.
  static SweepMotion through(std::span<const TimedMotion> others);
};

}  // namespace remount::odometry
