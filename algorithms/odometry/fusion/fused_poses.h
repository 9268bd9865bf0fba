// Poses of the LiDAR from those of the vehicle, and where they rest on more than scans.
#pragma once

#include <vector>

#include "algorithms/odometry/fusion/fusion_odometry.h"

namespace remount::odometry {

/// The LiDAR's poses in the odometry frame, which then has its origin at the first scan's vehicle.
std::vector<motion::StampedPose> odometry_from_lidar(const std::vector<FusedScan>& scans,
                                                     const RigidTransform& vehicle_from_lidar);

/// The same as the motions from scan to scan add up to: gravity and barometer correct the pose through the mounting,
/// and what is to judge that must not contain it.
std::vector<motion::StampedPose> uncorrected_odometry_from_lidar(const std::vector<FusedScan>& scans,
                                                                 const RigidTransform& vehicle_from_lidar);

/// How the motion since the scan before may err where the scan does not tell it: of the LiDAR's place (m) and attitude
/// (rad), in its axes at that scan. One column for each axis of the vehicle, along or about which sensors may have
/// erred by as much as the whole motion; zero where the scan tells everything.
std::vector<Matrix6d> untold_motions(const std::vector<FusedScan>& scans, const RigidTransform& vehicle_from_lidar);

}  // namespace remount::odometry
