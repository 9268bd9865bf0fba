// Results of calibrations that were cancelled before their end.
#pragma once

#include "algorithms/calibration/calibration_result.h"

namespace remount::results {

/// The result says so, in status, message and advice: it is none to rely on. Without the second pass, scans are
/// compensated through a first guess of X, and sigma does not know that.
void mark_preliminary(calibration::CalibrationResult& result);
bool is_preliminary(const calibration::CalibrationResult& result);

}  // namespace remount::results
