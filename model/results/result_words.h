// What is said of a result in every place that shows it.
#pragma once

#include <vector>

#include "algorithms/calibration/calibration_result.h"

namespace remount::results {

/// True for a solution that observes none of the six.
bool knows_nothing(const calibration::CalibrationResult& result);

/// Whether there is an X to show: it is usable, or the data contradict each other and it is worth a look.
bool has_mounting(const calibration::CalibrationResult& result);

/// Whether aligning the clouds of all accepted pairs together was its last step; a solution from the pairs lacks it.
bool is_aligned_together(const calibration::CalibrationResult& result);

/// That the sessions' own answers scatter more than their errors explain; empty where they do not, or nothing is known.
Message disagreement_words(const calibration::CalibrationResult& result);

/// How an offset between the clocks that was found is used: "applied", "an unknown of X, in its sigmas", "not applied".
Message clock_use_words(const calibration::TimeOffset& clock);

/// The offset of the clocks with its sigma and how it is used, where it is known; of several sessions each.
std::vector<Message> clock_words(const calibration::CalibrationResult& result);

/// As files have it in English; in words otherwise.
Message status_word(calibration::Status status);

}  // namespace remount::results
