// The six parameters of X as people read and type them: m and degrees. Everything else computes in radians.
#pragma once

#include <algorithm>
#include <cmath>

#include "algorithms/calibration/parameter.h"

namespace remount::results {

inline double on_screen(calibration::Parameter parameter, double value) {
  return calibration::is_angle(parameter) ? radians_to_degrees(value) : value;
}

/// Decimals of a value, and of its sigma, so that two digits of the sigma are shown: 0.764 with 0.013. Six at most,
/// which is a micrometre.
inline int justified_decimals(double sigma) {
  constexpr int kMost = 6;
  if (!(sigma > 0.0) || !std::isfinite(sigma)) return kMost;
  // As a number with two digits is rounded: 0.0999 is shown as 0.10, not as 0.100.
  const int first_digit = static_cast<int>(std::floor(std::log10(sigma * (1.0 + 5e-3))));
  return std::clamp(1 - first_digit, 0, kMost);
}

/// x, y, z in m, yaw, pitch, roll in degrees.
inline calibration::PerParameter<double> six_on_screen(const RigidTransform& a_from_b) {
  calibration::PerParameter<double> values = calibration::parameters_of(a_from_b);
  for (const calibration::Parameter parameter : calibration::kParameters)
    values[parameter] = on_screen(parameter, values[parameter]);
  return values;
}

}  // namespace remount::results
