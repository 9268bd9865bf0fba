// The pipeline on the poses of an odometry of all sensors, which needs the mounting that it looks for.
#pragma once

#include "model/method_registry/calibration_method.h"

namespace remount::methods {

extern const method_registry::CalibrationMethod kFusionOdometryMethod;

pipeline::PipelineOutput run_fusion_method(const pipeline::PipelineInput& input, Progress& progress);

}  // namespace remount::methods
