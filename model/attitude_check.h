// Whether the attitude of an INS means what its format or manifest says, judged by the direction of travel.
#pragma once

#include <vector>

#include "algorithms/calibration/calibration_result.h"
#include "model/session.h"

namespace remount {

/// Poses of the INS in a metric frame: east, north, up about the first sample, or the poses of the file.
std::vector<StampedPose> metric_poses(const Session& session);

/// Finding "heading-against-travel" (Problem) where the direction of travel, seen from the INS, changes as the vehicle
/// turns: rotations and positions then belong to different conventions, and no X can be right. Any constant direction
/// is fine: sensors are mounted sideways and backwards, and vehicles drive in reverse. "attitude-upside-down" (Problem)
/// where an INS with known axes has them pointing down. Nothing where the vehicle travels less than some 20 m.
std::vector<Finding> attitude_findings(const Session& session);

/// Where a session's heading goes against its travel and the pairs do not fit either: a usable result becomes
/// inconsistent, and the advice is to look at the attitude, not to drive. A robot that moves sideways at will has pairs
/// that fit, and keeps its result.
void blame_attitude(const std::vector<Finding>& findings, CalibrationResult& result);

}  // namespace remount
