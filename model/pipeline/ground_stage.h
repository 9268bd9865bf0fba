// The ground in the scans, for an INS whose height above it is known.
#pragma once

#include "algorithms/calibration/measured.h"
#include "model/pipeline/pipeline.h"
#include "model/pipeline/register_stage.h"

namespace remount::pipeline {

/// Mean ground plane over keyframes spread evenly through the drive, in the lidar frame. Nothing where fewer than five
/// scans show it. Unreadable scans are left out (they are reported where objects are found).
std::optional<calibration::ObservedGround> observe_ground(const StageContext& context, const ScanStore& scans,
                                                          Progress& progress);

/// A finding, once, that the given height of the INS cannot be used.
void report_unseen_ground(PipelineOutput& output);

}  // namespace remount::pipeline
