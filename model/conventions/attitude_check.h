// Whether the attitude of an INS means what its format or manifest says, judged by the direction of travel.
#pragma once

#include <vector>

#include "algorithms/calibration/calibration_result.h"
#include "model/conventions/metric_poses.h"
#include "model/drive/session.h"

namespace remount::conventions {

/// Where the heading does not follow the direction of travel and would otherwise, a finding (Problem) names how, for no
/// mounting can be right then: "attitude-convention" under another convention, "attitude-columns" with yaw and another
/// angle exchanged, "attitude-unit" in degrees, "position-columns" with latitude and longitude exchanged.
/// "heading-against-travel" (Warning) where it follows under none; "attitude-upside-down" (Warning) where INS axes that
/// are declared with z up point down. Where yaw is right, pitch and roll are judged (attitude_columns.h). Any constant
/// direction of travel is fine: sensors are mounted sideways and backwards, and vehicles drive in reverse. Nothing
/// where the vehicle moves for less than some five seconds, and where the reader found that the unit of the angles is
/// wrong. Where poses are inverted (inverted_poses.h), only that is said.
std::vector<drive::Finding> attitude_findings(const drive::Session& session);
std::vector<drive::Finding> attitude_findings(const drive::Session& session, const MetricPoses& poses);

/// Where one of those Problems was found, what was solved becomes inconsistent, and the advice says so first.
void blame_attitude(const std::vector<drive::Finding>& findings, calibration::CalibrationResult& result);

}  // namespace remount::conventions
