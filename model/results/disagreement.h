// Whether INS and scans tell the same motions under a result.
#pragma once

#include <vector>

#include "algorithms/calibration/calibration_result.h"
#include "model/drive/session.h"

namespace remount::results {

/// Finding "motions-differ" (Problem) where the accepted pairs of a usable result turn otherwise than the INS says by
/// more than any INS or registration errs: then it is no noise, and no sigma that is taken from it holds. Takes an
/// earlier one of that code away.
void report_disagreement(const calibration::CalibrationResult& result, std::vector<drive::Finding>& findings);

}  // namespace remount::results
