// A solution outside the search range, the same for every method.
#pragma once

#include "algorithms/calibration/calibration_result.h"
#include "messages/calibration.h"

namespace remount::calibration {

/// Status, message and advice. @param outside as outside_range() says it; not empty
inline void refuse_out_of_range(Message outside, CalibrationResult& result) {
  result.conclude(Status::OutOfRange, say::outside_search_range(std::move(outside)));
  result.advice.insert(result.advice.begin(), say::widen_search_range());
}

}  // namespace remount::calibration
