// The axis about which a LiDAR turned, in the LiDAR's own frame.
#pragma once

#include <vector>

#include "algorithms/geometry/rigid_transform.h"

namespace remount::calibration {

/// Every pose carries the axis, as it lies in the LiDAR's frame, to one and the same line. Both are sought together, so
/// that an error that all poses have in common, such as that of the scan they were aligned with, moves the line that is
/// left aside and not the axis.
struct SlewAxis {
  bool found = false;
  Eigen::Vector3d direction_in_lidar = Eigen::Vector3d::UnitZ();  ///< unit length, either sense
  Eigen::Vector3d centre_in_lidar_m = Eigen::Vector3d::Zero();    ///< point of the axis nearest to the LiDAR
  /// Of the centre, then of the direction under direction <- Exp(phi) direction; LiDAR axes, [m; rad]. Nothing along
  /// the axis: the centre is at the LiDAR's height by its definition.
  Matrix6d covariance = Matrix6d::Zero();
};

/// Least squares of the attitudes for the direction and of positions with attitudes for the centre; poses far off count
/// less and less (Tukey). The covariance is that which the residuals show; of an error that stays the same in the
/// LiDAR's axes over the whole turn, and leaves none, it has what those show that change slowly. Not found where there
/// are fewer than eight poses or they do not turn.
SlewAxis fit_slew_axis(const std::vector<RigidTransform>& first_from_lidar);

}  // namespace remount::calibration
