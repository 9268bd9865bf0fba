// Whether pitch and roll of an INS are what they are taken for: each may count the other way, or be the other one.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "model/conventions/metric_poses.h"
#include "model/drive/session.h"

namespace remount::conventions {

inline constexpr const char* kAttitudeColumns = "attitude-columns";

/// How the INS and another sensor on the same body turned meanwhile.
struct SharedTurn {
  Eigen::Matrix3d world_from_ins_a, world_from_ins_b;
  Eigen::Matrix3d other_b_from_other_a;
};

/// Finding "attitude-columns" (Problem) where pitch and roll contradict what else is known, and would agree with it
/// exchanged or with another sign. What is asked: the slope of the path (pitch; of roll it knows nothing), the specific
/// force of the IMU, the turns of a LiDAR's odometry (these do not see half a turn about the vertical: pitch and roll
/// both negated, or exchanged with one of them negated). Nothing where none of them varies enough, as on level ground,
/// and where pitch and roll are assumed to be none.
std::optional<drive::Finding> attitude_column_finding(const drive::Session& session, const MetricPoses& poses);

/// The same from turns alone: those that were registered.
std::optional<drive::Finding> attitude_column_finding(const std::vector<SharedTurn>& turns, const std::string& where);

}  // namespace remount::conventions
