// What the calibration of a slewing machine shows beside the mounting.
#pragma once

#include "algorithms/calibration/slew/slew.h"

namespace remount::calibration {

/// Adds centre, radius, arc, residuals and angles of a result that is found.
void name_slew_quantities(SlewResult& result);

/// Adds the plots: the turn in the machine's frame, and its distances from the circle.
void draw_slew(const SlewData& data, SlewResult& result);

}  // namespace remount::calibration
