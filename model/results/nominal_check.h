// Whether the result and the nominal mounting speak of the same installation.
#pragma once

#include <optional>
#include <vector>

#include "algorithms/calibration/calibration_result.h"
#include "model/drive/session.h"

namespace remount::results {

/// Finding "nominal-far" (Warning) where a usable result turned or moved so far from the nominal that no bracket bends
/// like that: the LiDAR sits otherwise than was assumed, or the nominal follows another convention. Names the inverse
/// (lidar_from_ins given for ins_from_lidar) where that is near the result. Takes an earlier one of that code away.
void report_nominal(const std::optional<RigidTransform>& nominal_ins_from_lidar,
                    const calibration::CalibrationResult& result, std::vector<drive::Finding>& findings);

}  // namespace remount::results
