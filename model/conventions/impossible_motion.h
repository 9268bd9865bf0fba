// Positions and measurements that no vehicle on the earth has.
#pragma once

#include <Eigen/Core>
#include <memory>
#include <vector>

#include "model/drive/session.h"

namespace remount::conventions {

/// Twice the way to the moon: whatever lies beyond is a number, not a place.
inline constexpr double kFarthestPosition_m = 1e9;

/// Finite, and no coordinate beyond that.
bool is_possible_position(const Eigen::Vector3d& position_m);
bool is_possible_motion(const RigidTransform& motion);

/// Takes out poses, fixes and measurements that are impossible, and poses of the INS that lie more than 250 km from
/// where most of them are: a glitch of a filter, or another zone of the grid. What was taken out becomes findings
/// "off-earth", one for each stream.
/// Throws Error(Format) where nothing is left of the motion of the INS or of the LiDAR.
void leave_out_impossible(drive::Session& session);

/// The same sessions, those with something impossible in them as copies without: what was made in memory has met no
/// reader, and numbers whose squares are infinite would reach every solver.
std::vector<std::shared_ptr<const drive::Session>> possible_sessions(
    std::vector<std::shared_ptr<const drive::Session>> sessions);

}  // namespace remount::conventions
