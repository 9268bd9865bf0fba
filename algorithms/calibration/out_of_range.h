// A solution outside the search range, the same for every method.
#pragma once

#include <string>

#include "algorithms/calibration/calibration_result.h"

namespace remount {

/// Status, message and advice. @param outside as outside_range() words it; not empty
inline void refuse_out_of_range(const std::string& outside, CalibrationResult& result) {
  result.status = Status::OutOfRange;
  result.message = "The solution lies outside the search range: " + outside + ".";
  result.advice.insert(result.advice.begin(),
                       "Widen the search range where it is too narrow. Where it is right, the data contradict it: "
                       "check axes and units of the INS, and whether the LiDAR is the one that the range is for.");
}

}  // namespace remount
