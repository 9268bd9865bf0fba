// The six parameters of X as people read and type them: m and degrees. Everything else computes in radians.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "algorithms/geometry/rigid_transform.h"

namespace remount {

/// Of parameter i in the order of kParameterNames.
inline bool is_angle(std::size_t i) { return i >= 3; }
inline double on_screen(std::size_t i, double value) { return is_angle(i) ? radians_to_degrees(value) : value; }

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
inline std::array<double, 6> six_on_screen(const RigidTransform& ins_from_lidar) {
  const SixParameters six = six_from_rigid(ins_from_lidar);
  return {six.x_m,
          six.y_m,
          six.z_m,
          radians_to_degrees(six.yaw_rad),
          radians_to_degrees(six.pitch_rad),
          radians_to_degrees(six.roll_rad)};
}

}  // namespace remount
