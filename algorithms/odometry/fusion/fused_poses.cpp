#include "algorithms/odometry/fusion/fused_poses.h"

#include <algorithm>

namespace remount::odometry {

std::vector<motion::StampedPose> odometry_from_lidar(const std::vector<FusedScan>& scans,
                                                     const RigidTransform& vehicle_from_lidar) {
  std::vector<motion::StampedPose> poses;
  poses.reserve(scans.size());
  for (const FusedScan& scan : scans) poses.push_back({scan.stamp_ns, scan.odometry_from_vehicle * vehicle_from_lidar});
  return poses;
}

std::vector<motion::StampedPose> uncorrected_odometry_from_lidar(const std::vector<FusedScan>& scans,
                                                                 const RigidTransform& vehicle_from_lidar) {
  std::vector<motion::StampedPose> poses;
  poses.reserve(scans.size());
  RigidTransform start_from_vehicle = RigidTransform::Identity();
  for (const FusedScan& scan : scans) {
    start_from_vehicle = start_from_vehicle * scan.before_from_vehicle;
    poses.push_back({scan.stamp_ns, start_from_vehicle * vehicle_from_lidar});
  }
  return poses;
}

std::vector<Matrix6d> untold_motions(const std::vector<FusedScan>& scans, const RigidTransform& vehicle_from_lidar) {
  constexpr double kLeast_m = 0.01, kLeast_rad = 1e-3,
                   kTurn_radpm = 0.1;  // where little moved, and by surfaces' distance
  const Eigen::Matrix3d lidar_from_vehicle = vehicle_from_lidar.linear().transpose();
  // From a motion of the vehicle to that of the LiDAR, which sits elsewhere.
  Matrix6d to_lidar = Matrix6d::Zero();
  to_lidar.topLeftCorner<3, 3>() = to_lidar.bottomRightCorner<3, 3>() = lidar_from_vehicle;
  to_lidar.topRightCorner<3, 3>() = -lidar_from_vehicle * skew(vehicle_from_lidar.translation());
  std::vector<Matrix6d> motions;
  motions.reserve(scans.size());
  for (const FusedScan& scan : scans) {
    const double way_m = std::max(kLeast_m, scan.before_from_vehicle.translation().norm());
    const double turn_rad =
        std::max({kLeast_rad, kTurn_radpm * way_m, so3_log(scan.before_from_vehicle.linear()).norm()});
    Matrix6d axes = Matrix6d::Zero();  // odometry from vehicle
    axes.topLeftCorner<3, 3>() = axes.bottomRightCorner<3, 3>() = scan.odometry_from_vehicle.linear();
    Vector6d size;
    size << Eigen::Vector3d::Constant(way_m), Eigen::Vector3d::Constant(turn_rad);
    motions.push_back(to_lidar * axes.transpose() * scan.untold * axes * size.asDiagonal());
  }
  if (!motions.empty()) motions.front().setZero();  // there is none before
  return motions;
}

}  // namespace remount::odometry
