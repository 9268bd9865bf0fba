#include "algorithms/calibration/agreement.h"

#include <cmath>

#include "algorithms/geometry/rotation.h"

namespace remount::calibration {

ResultDifference difference_of(const CalibrationResult& first, const CalibrationResult& second) {
  const MountingFrames frames = first.mounting.frames();
  ResultDifference out;
  const PerParameter<double> a = parameters_of(first.mounting.reference_from_sensor),
                             b = parameters_of(second.mounting.between(frames.reference, *frames.sensor));
  const bool usable = is_usable(first) && is_usable(second);
  for (const Parameter parameter : kParameters) {
    const std::optional<double> sigma_a = first.estimate(parameter).sigma, sigma_b = second.estimate(parameter).sigma;
    const double sigma = usable && sigma_a && sigma_b ? std::hypot(*sigma_a, *sigma_b) : std::nan("");
    const double apart = a[parameter] - b[parameter];
    const bool known = std::isfinite(sigma);
    out.difference[parameter] = !known ? std::nan("") : is_angle(parameter) ? wrap_angle_rad(apart) : apart;
    out.sigma[parameter] = known ? sigma : std::nan("");
  }
  return out;
}

std::optional<LargestDifference> largest_difference(const ResultDifference& difference) {
  std::optional<LargestDifference> largest;
  for (const Parameter parameter : kParameters) {
    const double sigmas = std::abs(difference.difference[parameter]) / difference.sigma[parameter];
    if (std::isfinite(sigmas) && (!largest || sigmas > largest->sigmas)) largest = LargestDifference{parameter, sigmas};
  }
  return largest;
}

}  // namespace remount::calibration
