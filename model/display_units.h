// The six parameters of X as people read and type them: m and degrees. Everything else computes in radians.
#pragma once

#include <array>
#include <cstddef>

#include "algorithms/geometry/rigid_transform.h"

namespace remount {

/// Of parameter i in the order of kParameterNames.
inline bool is_angle(std::size_t i) { return i >= 3; }
inline double on_screen(std::size_t i, double value) { return is_angle(i) ? radians_to_degrees(value) : value; }

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
