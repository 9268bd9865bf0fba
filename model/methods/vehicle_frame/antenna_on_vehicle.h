// What a drive without poses of a sensor still tells: where its GNSS antenna sits, from wheels and yaw rate.
#pragma once

#include "model/pipeline/pipeline.h"

namespace remount::methods {

/// Lever arm of the antenna in the vehicle frame (x and y), with the integrated trajectory against the positions.
/// Rotation and height stay unobserved. Of the first session; others are findings.
pipeline::PipelineOutput run_antenna_on_vehicle(const pipeline::PipelineInput& input, Progress& progress);

}  // namespace remount::methods
