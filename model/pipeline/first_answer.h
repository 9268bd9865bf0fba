// What can be said at once after an edit, while the whole solution is computed. See also solve_at_once in pipeline.h.
#pragma once

#include "model/pipeline/pipeline.h"

namespace remount::pipeline {

/// Judges the candidates of `output` by the search range of `input` and ranks them again. What lies outside the range
/// goes last; no new candidate is sought, and the result stays.
void rank_again(const PipelineInput& input, PipelineOutput& output);

/// Gives `output` another X, with the residuals of its pairs under that.
void answer_with(const RigidTransform& ins_from_lidar, PipelineOutput& output);

}  // namespace remount::pipeline
