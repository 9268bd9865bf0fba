// Wheels and IMU integrated against the poses of a sensor: vehicle_from_sensor.
#pragma once

#include "model/method_registry/calibration_method.h"

namespace remount {

extern const CalibrationMethod kVehicleFrameMethod;

/// Whether the method falls back to the antenna: no poses of a sensor, but positions, wheels and rates.
bool has_antenna_only(const Session& session);

PipelineOutput run_vehicle_frame(const PipelineInput& input, Progress& progress);

}  // namespace remount
