// Screw invariants of P X = X Q, which hold whatever X is (Chen 1991): failed registrations show before any X is known.
#pragma once

#include "algorithms/motion/pair.h"

namespace remount::motion {

/// @param rotation_sigma_rad 1-sigma of theta_P - theta_Q
/// @param translation_sigma_m 1-sigma of the translation along the axis, apart from the error of the axis itself
/// @param threshold score above which the test fails
ScrewTest screw_test(const RigidTransform& ins_b_from_ins_a, const RigidTransform& lidar_b_from_lidar_a,
                     double rotation_sigma_rad, double translation_sigma_m, double threshold);

}  // namespace remount::motion
