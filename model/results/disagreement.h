// Whether INS and scans tell the same motions under a result.
#pragma once

#include <vector>

#include "algorithms/calibration/calibration_result.h"
#include "model/drive/session.h"

namespace remount::results {

/// Finding "motions-differ" (Warning) where the accepted pairs of a usable result turn otherwise than the INS says by
/// more than an INS for surveys and the registration of scans err by: then it is hardly noise, and a sigma that was
/// taken from it may not hold. Takes an earlier one of that code away.
void report_disagreement(const calibration::CalibrationResult& result, std::vector<drive::Finding>& findings);

}  // namespace remount::results
