#include "algorithms/calibration/agreement.h"

#include <cmath>

#include "algorithms/geometry/rotation.h"

namespace remount {

ResultDifference difference_of(const CalibrationResult& first, const CalibrationResult& second) {
  ResultDifference out;
  const SixParameters a = six_from_rigid(first.ins_from_lidar), b = six_from_rigid(second.ins_from_lidar);
  out.difference = {a.x_m - b.x_m,
                    a.y_m - b.y_m,
                    a.z_m - b.z_m,
                    wrap_angle_rad(a.yaw_rad - b.yaw_rad),
                    wrap_angle_rad(a.pitch_rad - b.pitch_rad),
                    wrap_angle_rad(a.roll_rad - b.roll_rad)};
  const bool usable = is_usable(first) && is_usable(second);
  for (std::size_t i = 0; i < out.sigma.size(); ++i) {
    const std::optional<double> sigma_a = first.sigma(i), sigma_b = second.sigma(i);
    out.sigma[i] = usable && sigma_a && sigma_b ? std::hypot(*sigma_a, *sigma_b) : std::nan("");
    if (!std::isfinite(out.sigma[i])) out.difference[i] = out.sigma[i] = std::nan("");
  }
  return out;
}

std::optional<LargestDifference> largest_difference(const ResultDifference& difference) {
  std::optional<LargestDifference> largest;
  for (std::size_t i = 0; i < difference.sigma.size(); ++i) {
    const double sigmas = std::abs(difference.difference[i]) / difference.sigma[i];
    if (std::isfinite(sigmas) && (!largest || sigmas > largest->sigmas)) largest = LargestDifference{i, sigmas};
  }
  return largest;
}

}  // namespace remount
