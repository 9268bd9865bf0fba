// How long the noise of the INS is averaged over in a LiDAR's keyframes.
#pragma once

#include <vector>

#include "algorithms/motion/sweep.h"
#include "model/pipeline/drive_motion.h"
#include "model/pipeline/pipeline.h"

namespace remount::rig {

/// Over which time a scan averages the noise of the INS: over its points' if the motion that compensates them does not,
/// over `fitted_s` if they are of one moment (motion::MotionTrack::averaged_s), and over a little more than the longer
/// where both do. docs/maths/rig.md (G13)
motion::Sweep averaged_time(const motion::Sweep& swept, double fitted_s);

/// The same of the keyframes of each session, with the scans that were gathered to them.
std::vector<motion::Sweep> averaged_times(const pipeline::DriveMotion& motion, const pipeline::PipelineOutput& output);

}  // namespace remount::rig
