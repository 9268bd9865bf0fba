// The vehicle frame with the offset between the clocks of sensor and vehicle.
#pragma once

#include "algorithms/calibration/vehicle_frame.h"
#include "model/pipeline.h"

namespace remount {

/// Solves, with an offset of each session's sensor against the turns of its IMU (or of the INS that stands in for it)
/// from rates of turning. Where it stands out, or the settings ask for it, stamps of the sensor's poses in `drives` are
/// moved by it, and its own error joins the sigmas; what is not taken out joins them by how far it moves X.
VehicleFrameResult solve_vehicle_frame_with_clocks(const PipelineInput& input, std::vector<VehicleDrive>& drives,
                                                   Progress& progress);

}  // namespace remount
