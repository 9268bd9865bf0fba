// A frame with its z axis up, for work on a scan of a sensor that may be mounted in any orientation.
#pragma once

#include <Eigen/Core>

#include "algorithms/geometry/shortest_rotation.h"

namespace remount::cloud {

/// Rotation that takes the lidar's axes to level ones by the shortest way: z along `up_in_lidar` (unit length).
inline Eigen::Matrix3f level_from_lidar(const Eigen::Vector3f& up_in_lidar) {
  return shortest_rotation(up_in_lidar, Eigen::Vector3f::UnitZ());
}

}  // namespace remount::cloud
