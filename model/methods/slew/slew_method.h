// Ground, swept arm and full turn of an excavator: machine_from_lidar.
#pragma once

#include "model/method_registry/calibration_method.h"

namespace remount {

extern const CalibrationMethod kSlewMethod;

PipelineOutput run_slew(const PipelineInput& input, Progress& progress);

}  // namespace remount
