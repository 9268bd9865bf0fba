// What a cancelled calibration had finished, made ready to be solved.
#pragma once

#include "model/pipeline/pipeline.h"

namespace remount::pipeline {

/// Pairs that were aligned when `output`'s run was cancelled may take part in a solution (solve_again); the others are
/// rejected with the reason, and a finding says how many. Pairs that the user decided keep their state. Returns how
/// many were aligned; 0, with nothing changed, also where the solution would need what was not reached: clock offsets
/// that are to be applied.
std::size_t keep_finished(const PipelineInput& input, PipelineOutput& output);

/// A usable solution of what keep_finished left is marked as preliminary.
void mark_if_cut_short(PipelineOutput& output);

}  // namespace remount::pipeline
