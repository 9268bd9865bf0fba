// Scans as a calibration uses them, and as it used them once it is finished.
#pragma once

#include "model/pipeline/pipeline.h"
#include "model/pipeline/scan_store.h"

namespace remount::pipeline {

/// Lets `scans` be mended, gathered and compensated for motion as the output has it.
void compensate_as_solved(const PipelineInput& input, const PipelineOutput& output, ScanStore& scans);

}  // namespace remount::pipeline
