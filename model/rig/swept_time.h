// When the points of a LiDAR's keyframes were measured.
#pragma once

#include "model/pipeline/pipeline.h"

namespace remount::rig {

/// From the stamp of a keyframe, s; both zero: at once.
struct SweptTime {
  double from_s = 0.0, until_s = 0.0;
};

/// Of a keyframe as the calibration compensated its motion, with the scans that were gathered to it. The first scan
/// that can be read speaks for those of its session, the longest for all sessions.
SweptTime swept_time(const pipeline::PipelineInput& input, const pipeline::PipelineOutput& output);

}  // namespace remount::rig
