// Whether the attitude of an INS means what its format or manifest says, judged by the direction of travel.
#pragma once

#include <vector>

#include "algorithms/calibration/calibration_result.h"
#include "model/metric_poses.h"
#include "model/session.h"

namespace remount {

/// Finding "attitude-convention" (Problem) where the heading does not follow the direction of travel and would under
/// another convention, which it names: no mounting can be right then. "heading-against-travel" (Warning) where it
/// follows under none; "attitude-upside-down" (Warning) where INS axes that are declared with z up point down. Any
/// constant direction of travel is fine: sensors are mounted sideways and backwards, and vehicles drive in reverse.
/// Nothing where the vehicle moves for less than some five seconds.
std::vector<Finding> attitude_findings(const Session& session);
std::vector<Finding> attitude_findings(const Session& session, const MetricPoses& poses);

/// Where another convention is the right one, what was solved becomes inconsistent, and the advice says so first.
void blame_attitude(const std::vector<Finding>& findings, CalibrationResult& result);

}  // namespace remount
