// The smallest rotation between two directions.
#pragma once

#include <Eigen/Core>

namespace remount {

/// Rotation that takes direction `from` to direction `to` by the shortest way; neither needs unit length. Between
/// opposite directions it is half a turn about some axis across them, the same on every call.
Eigen::Matrix3d shortest_rotation(const Eigen::Vector3d& from, const Eigen::Vector3d& to);
Eigen::Matrix3f shortest_rotation(const Eigen::Vector3f& from, const Eigen::Vector3f& to);

}  // namespace remount
