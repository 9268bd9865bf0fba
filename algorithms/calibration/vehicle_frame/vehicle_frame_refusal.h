// Streams of a vehicle that are not in the units that they should be in; used by vehicle_frame.cpp.
#pragma once

#include "algorithms/calibration/vehicle_frame/vehicle_frame_start.h"

namespace remount::calibration {

/// Whether rates in degrees, or ways of another unit, forbid to solve; `calibration` then says why, and claims nothing.
bool refused_for_units(const VehicleFrameStart& start, const VehicleFrameOptions& options,
                       CalibrationResult& calibration);

}  // namespace remount::calibration
