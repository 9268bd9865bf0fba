// Scans as a finished calibration used them.
#pragma once

#include "model/pipeline/pipeline.h"
#include "model/pipeline/scan_store.h"

namespace remount::pipeline {

/// Lets `scans` compensate motion as the calibration did.
void compensate_as_solved(const PipelineInput& input, const PipelineOutput& output, ScanStore& scans);

}  // namespace remount::pipeline
