// What a calibration tells of the errors of the LiDAR's beams.
#pragma once

#include "model/pipeline/pipeline.h"
#include "model/pipeline/register_stage.h"

namespace remount::pipeline {

/// The quantities and plots of the present result; none where the beams were no unknowns.
void tell_beams(PipelineOutput& output);

/// The finding, where any were taken out, with how thick surfaces are in the map of the scans as they were recorded and
/// of the mended ones.
void report_mended_beams(const StageContext& context, const ScanStore& as_recorded, PipelineOutput& output,
                         Progress& progress);

}  // namespace remount::pipeline
