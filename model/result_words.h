// What is said of a result in every place that shows it.
#pragma once

#include <string>

#include "algorithms/calibration/calibration_result.h"

namespace remount {

/// Whether aligning the clouds of all accepted pairs together was its last step; a solution from the pairs lacks it.
bool is_aligned_together(const CalibrationResult& result);

/// That the sessions' own answers scatter more than their errors explain; empty where they do not, or nothing is known.
std::string disagreement_words(const CalibrationResult& result);

}  // namespace remount
