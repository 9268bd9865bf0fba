// Whether the wheels of a drive turn the way the vehicle goes.
#pragma once

#include <vector>

#include "algorithms/calibration/vehicle_frame/vehicle_frame.h"

namespace remount::methods {

/// Where the speeds of the wheels say backwards while the INS says forwards, or, without an INS that has positions,
/// while the IMU is pressed to the wrong side in turns, `result` becomes inconsistent and claims nothing: half a turn
/// of yaw is at stake, and the sensor's poses show it to no one. So it does where these forces say that the vehicle was
/// found upside down: half a turn of roll. Wheels by forces need the mounting of the IMU as it is stated, for it must
/// be known which side of the vehicle is which.
void refuse_backward_wheels(const std::vector<calibration::VehicleDrive>& drives,
                            const calibration::VehicleFrameOptions& options, calibration::VehicleFrameResult& result);

}  // namespace remount::methods
