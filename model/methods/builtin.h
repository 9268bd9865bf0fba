// The methods that are built in, one file each.
#pragma once

#include "model/methods/calibration_method.h"

namespace remount {

/// Alignment of the LiDAR's trajectory with INS poses or GNSS positions. trajectory_method.cpp
PipelineOutput run_trajectory_method(const PipelineInput& input, Progress& progress);
PipelineOutput run_fusion_method(const PipelineInput& input, Progress& progress);
/// Wheels and IMU integrated against the poses of a sensor: vehicle_from_sensor. vehicle_frame_method.cpp
PipelineOutput run_vehicle_frame(const PipelineInput& input, Progress& progress);
/// Ground, swept arm and full turn of an excavator: machine_from_lidar. slew_method.cpp
PipelineOutput run_slew(const PipelineInput& input, Progress& progress);

}  // namespace remount
