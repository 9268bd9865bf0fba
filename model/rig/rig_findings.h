// What is to be said of several LiDARs together.
#pragma once

#include "model/rig/rig_calibration.h"

namespace remount::rig {

/// Adds to `output.findings`: LiDARs that take no part and why, LiDARs that no pairs join with the others, and LiDARs
/// that contradict the others.
void report_rig(RigOutput& output);

/// Heights that only LiDARs together are silent about: "height of all five together: not observable; front against
/// rear: 1.8 mm". Nothing where every height is known, or none is against another.
std::vector<Message> words_of_heights(const RigOutput& output);

}  // namespace remount::rig
