// Attitudes that are logged in steps so coarse that the steps are errors of their own.
#pragma once

#include <vector>

#include "algorithms/motion/ins_sample.h"

namespace remount::conventions {

struct AttitudeRounding {
  double step_rad = 0.0;     ///< of yaw, pitch and roll; 0: none is to be seen
  double sigma_rad = 0.0;    ///< 1-sigma of an angle by its rounding
  double lasting_rad = 0.0;  ///< of that, what stays the same: an angle that hardly changes is rounded the same way
};

/// From the changes of the angles from sample to sample, all of which are multiples of a step.
AttitudeRounding attitude_rounding(const std::vector<motion::InsSample>& ins);

}  // namespace remount::conventions
