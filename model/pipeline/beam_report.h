// What a calibration tells of the errors of the LiDAR's beams.
#pragma once

#include "model/pipeline/pipeline.h"
#include "model/pipeline/register_stage.h"

namespace remount::pipeline {

/// The quantities and plots of the present result; none where the beams were no unknowns.
void tell_beams(PipelineOutput& output);

/// How thick surfaces in the map of the scans are under the X of `output`, as they were recorded and mended, m.
struct BeamThickness {
  double as_recorded_m, mended_m;
};
/// Nothing where no errors were taken out, or where the map was not checked.
std::optional<BeamThickness> thickness_of_beams(const StageContext& context, const PipelineInput& input,
                                                const PipelineOutput& output, Progress& progress);

/// The finding, anew, where errors were taken out of the scans.
void report_mended_beams(const std::optional<BeamThickness>& thickness, PipelineOutput& output);

}  // namespace remount::pipeline
