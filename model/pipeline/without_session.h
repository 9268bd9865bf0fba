// A calibration without one of its sessions, where its result does not rest on that one.
#pragma once

#include <optional>

#include "model/pipeline/pipeline.h"

namespace remount::pipeline {

/// What was calibrated, without the session of this number: the same X, with the pairs, keyframes and findings of the
/// others, which are numbered anew. Nothing where the result rests on the session or may do so: a pair of it was
/// accepted, the method knows no pairs, there is no usable result, or the ground in all scans was used.
std::optional<PipelineOutput> without_session(const PipelineInput& input, const PipelineOutput& output,
                                              motion::SessionIndex session);

/// What such an output was made of.
PipelineInput input_without_session(PipelineInput input, motion::SessionIndex session);

}  // namespace remount::pipeline
