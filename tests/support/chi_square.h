// How far the sum of squared errors over their sigma may lie from their number.
#pragma once

#include <cmath>

namespace remount::testing {

/// Normal quantiles: one case in a hundred lies above the first, and one outside plus and minus the second.
inline constexpr double kOnePercentAbove = 2.3263, kOnePercentOutside = 2.5758;

/// Quantile of chi-square by Wilson and Hilferty; within 0.3% from ten degrees of freedom on.
inline double chi_square_quantile(double freedom, double normal_quantile) {
  if (!(freedom > 0.0)) return 0.0;
  const double spread = 2.0 / (9.0 * freedom);
  return freedom * std::pow(1.0 - spread + normal_quantile * std::sqrt(spread), 3.0);
}

}  // namespace remount::testing
