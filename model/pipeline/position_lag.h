// Positions of an INS that are of another age than its attitudes.
#pragma once

#include <vector>

#include "algorithms/calibration/calibration_result.h"
#include "model/pipeline/drive_motion.h"
#include "model/pipeline/pipeline.h"

namespace remount::pipeline {

inline constexpr const char* kPositionLag = "ins-position-lag";
inline constexpr const char* kPositionsApart = "ins-positions-apart";

/// States the lags of `motion` as those of the result; where nothing was taken out, the estimates stay.
void state_position_lags(const DriveMotion& motion, bool applied, calibration::CalibrationResult& result);

/// A finding for each session whose positions are older than its attitudes, or younger, by more than the estimate errs;
/// and for each where that is open, for the two come in messages of different times, and makes up a part of the sigmas.
void report_position_lag(const PipelineInput& input, const calibration::CalibrationResult& result,
                         std::vector<drive::Finding>& findings);

}  // namespace remount::pipeline
