// Pose files that give the world in the body where the body in the world is meant.
#pragma once

#include <vector>

#include "model/drive/session.h"

namespace remount::conventions {

inline constexpr const char* kPosesInverted = "poses-inverted";

/// A Problem for the poses of the INS, and for those of the LiDAR, that keep to no axis of their body while the vehicle
/// travels, where their inverses do: a vehicle moves along one axis of its body. Nothing for positions on the earth,
/// where the vehicle moves for less than some five seconds, and for bodies that move at will (machines, hands).
std::vector<drive::Finding> inverted_pose_findings(const drive::Session& session);

}  // namespace remount::conventions
