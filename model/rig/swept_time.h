// When the points of a LiDAR's keyframes were measured.
#pragma once

#include <vector>

#include "algorithms/calibration/rig/rig.h"
#include "model/pipeline/pipeline.h"

namespace remount::rig {

/// Of keyframes of each session, as the calibration compensated their motion, with the scans that were gathered to
/// them: the longest of a few scans from the middle of the session, for its first may be the end of a turn.
std::vector<calibration::Sweep> swept_times(const pipeline::PipelineInput& input,
                                            const pipeline::PipelineOutput& output);

}  // namespace remount::rig
