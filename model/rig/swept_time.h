// When the points of a LiDAR's keyframes were measured.
#pragma once

#include <vector>

#include "algorithms/motion/sweep.h"
#include "model/pipeline/pipeline.h"

namespace remount::rig {

/// Of keyframes of each session, as the calibration compensated their motion, with the scans that were gathered to
/// them.
std::vector<motion::Sweep> swept_times(const pipeline::PipelineInput& input, const pipeline::PipelineOutput& output);

}  // namespace remount::rig
