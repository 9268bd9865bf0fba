// The methods that are built in, one file each.
#pragma once

#include "model/methods/calibration_method.h"

namespace remount {

/// Alignment of the LiDAR's trajectory with INS poses or GNSS positions (methods 2).
PipelineOutput run_trajectory_method(const PipelineInput& input, Progress& progress);
PipelineOutput run_fusion_method(const PipelineInput& input, Progress& progress);

}  // namespace remount
