// A degree, for limits that are stated in degrees.
#pragma once

#include "algorithms/geometry/rotation.h"

namespace remount {

inline constexpr double kDegree_rad = degrees_to_radians(1.0);

}  // namespace remount
