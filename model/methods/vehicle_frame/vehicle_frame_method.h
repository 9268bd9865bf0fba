// Wheels and IMU integrated against the poses of a sensor: vehicle_from_sensor.
#pragma once

#include "model/method_registry/calibration_method.h"

namespace remount::methods {

extern const method_registry::CalibrationMethod kVehicleFrameMethod;

/// Whether the method falls back to the antenna: no poses of a sensor, but positions, wheels and rates.
bool has_antenna_only(const drive::Session& session);

pipeline::PipelineOutput run_vehicle_frame(const pipeline::PipelineInput& input, Progress& progress);

}  // namespace remount::methods
