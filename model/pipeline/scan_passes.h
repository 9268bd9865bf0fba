// From proposed pairs of scans to a mounting: objects, registrations, the solution, and all of it once more through the
// mounting that was found.
#pragma once

#include "algorithms/calibration/pairwise/pairwise.h"
#include "model/pipeline/drive_motion.h"
#include "model/pipeline/pipeline.h"
#include "model/pipeline/shared_field.h"

namespace remount::pipeline {

/// Fills pairs, result and what they rest on in `output`, whose keyframes and pairs are proposed. A second pass that is
/// cancelled leaves what the first found: half of the pairs of each do not go together.
void calibrate_all_scans(const PipelineInput& input, DriveMotion& motion, const SharedField& field,
                         PipelineOutput& output, calibration::PairwiseDetails& details, Progress& progress);

}  // namespace remount::pipeline
