// Whether two answers to where the LiDAR sits agree within what they claim.
#pragma once

#include <optional>

#include "algorithms/calibration/calibration_result.h"

namespace remount::calibration {

/// X of one result minus X of another, component by component; NaN for one that either does not observe.
struct ResultDifference {
  PerParameter<double> difference;  ///< m, rad
  PerParameter<double> sigma;       ///< of the difference: both together, as if they shared no errors
};
/// All NaN where one of them has nothing to use. @throws Error (Contract) where they are of other frames
ResultDifference difference_of(const CalibrationResult& first, const CalibrationResult& second);

/// The component in which two results differ by the most sigma, and by how many.
struct LargestDifference {
  Parameter parameter = Parameter::X;
  double sigmas = 0.0;
};
/// Nothing where no component is observed by both.
std::optional<LargestDifference> largest_difference(const ResultDifference& difference);
/// More is no chance: of six components one differs by this much in a few of a thousand comparisons.
inline constexpr double kDiffer_sigma = 3.5;

}  // namespace remount::calibration
