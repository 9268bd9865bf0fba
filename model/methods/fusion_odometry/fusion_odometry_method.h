// The pipeline on the poses of an odometry of all sensors, which needs the mounting that it looks for.
#pragma once

#include "model/method_registry/calibration_method.h"

namespace remount {

extern const CalibrationMethod kFusionOdometryMethod;

PipelineOutput run_fusion_method(const PipelineInput& input, Progress& progress);

}  // namespace remount
