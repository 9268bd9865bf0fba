// What a calibration tells of the errors of the LiDAR's beams.
#pragma once

#include "model/pipeline/pipeline.h"
#include "model/pipeline/register_stage.h"

namespace remount::pipeline {

/// The quantities and plots of the present result; none where the beams were no unknowns. It then has what is known of
/// them beforehand.
void tell_beams(PipelineOutput& output);

/// How thick surfaces in the map of the scans are under the X of `output`, as they were recorded and mended, m.
struct BeamThickness {
  double as_recorded_m, mended_m;
};
/// Nothing where no errors were taken out, or where the map was not checked.
std::optional<BeamThickness> thickness_of_beams(const StageContext& context, const PipelineInput& input,
                                                const PipelineOutput& output, Progress& progress);

/// What was known and taken out of the scans as they were read, into the output of any method: many know nothing of
/// beams.
void add_known_beams(const cloud::BeamEstimate& known, PipelineOutput& output);

/// The finding, anew, where errors were taken out of the scans.
void report_mended_beams(const std::optional<BeamThickness>& thickness, PipelineOutput& output);

}  // namespace remount::pipeline
