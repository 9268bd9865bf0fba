// The vehicle frame with the offset between the clocks of sensor and vehicle.
#pragma once

#include <functional>

#include "algorithms/calibration/vehicle_frame/vehicle_frame.h"
#include "model/pipeline/pipeline.h"

namespace remount::methods {

/// How far X moves, under `perturb`, where the clock of a session is off by more. Where nothing usable comes of that
/// offset, of its opposite or of a part of them, in proportion to the first that does; where of none, by far more than
/// what counts as observed, for an X that such an offset destroys is not known.
/// @param solved_with the calibration where the clock is off by so much more
Vector6d moved_by_clock(double offset_s, const RigidTransform& vehicle_from_sensor,
                        const calibration::SolveOptions& options,
                        const std::function<calibration::CalibrationResult(double)>& solved_with);

/// Solves, with an offset of each session's sensor against the turns of its IMU (or of the INS that stands in for it)
/// from rates of turning. Where it stands out, or the settings ask for it, stamps of the sensor's poses in `drives` are
/// moved by it, and its own error joins the sigmas; what is not taken out joins them by how far it moves X.
calibration::VehicleFrameResult solve_vehicle_frame_with_clocks(const pipeline::PipelineInput& input,
                                                                std::vector<calibration::VehicleDrive>& drives,
                                                                Progress& progress);

}  // namespace remount::methods
