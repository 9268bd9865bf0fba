// The methods that are built in, one file each.
#pragma once

#include "model/methods/calibration_method.h"

namespace remount {

PipelineOutput run_fusion_method(const PipelineInput& input, Progress& progress);

}  // namespace remount
