// Ground, swept arm and full turn of an excavator: machine_from_lidar.
#pragma once

#include "model/method_registry/calibration_method.h"

namespace remount::methods {

extern const method_registry::CalibrationMethod kSlewMethod;

pipeline::PipelineOutput run_slew(const pipeline::PipelineInput& input, Progress& progress);

}  // namespace remount::methods
