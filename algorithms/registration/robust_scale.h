// The scale beyond which residuals count as disturbances.
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

namespace remount::registration {

/// Four standard deviations as estimated from the median of squared residuals, within limits. Reorders its input.
inline float robust_kernel_m(std::vector<float>& residuals2_m2, float smallest_m, float largest_m) {
  if (residuals2_m2.empty()) return largest_m;
  const auto middle = residuals2_m2.begin() + static_cast<std::ptrdiff_t>(residuals2_m2.size() / 2);
  std::nth_element(residuals2_m2.begin(), middle, residuals2_m2.end());
  return std::clamp(4.0f * 1.4826f * std::sqrt(*middle), smallest_m, largest_m);
}

inline constexpr float kSmallestKernel_m = 0.03f;

}  // namespace remount::registration
