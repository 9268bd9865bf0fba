// Where a rotation of X is open: what says where it lies beside the motion, and what turns with it.
// docs/maths/covariance.md (C22)
#pragma once

#include <optional>

#include "algorithms/geometry/rigid_transform.h"

namespace remount::calibration {

/// Information that the ground in the scans adds about roll and pitch of X: a road is level, and so is an INS on its
/// vehicle. Where X says that the ground leans, one of the two is wrong by as much. Nothing without ground.
/// @param up_in_lidar away from the ground, unit length
Matrix6d level_information(const std::optional<Eigen::Vector3d>& up_in_lidar, const RigidTransform& ins_from_lidar);

/// What yaw, pitch and roll may be off by where, without a nominal, a rotation is open (roll on a straight road): all
/// of X turns with it, far beyond what holds to first order. A LiDAR whose axis lies 2 degrees off the road's has yaw
/// and pitch of anything up to that. Zero where nothing is open.
/// @param information all that is known of X, under `perturb`, without a prior on rotation
Eigen::Vector3d turned_by_open_rotation(const RigidTransform& ins_from_lidar, const Matrix6d& information);

}  // namespace remount::calibration
