// Poses of an INS whose positions count from the north of a grid and whose attitudes from true north.
#pragma once

#include "model/drive/session.h"

namespace remount::conventions {

/// Drivers of GNSS receivers give positions in UTM, with or without its origin, beside attitudes to true north: the two
/// are apart by the grid's convergence, up to 3 degrees, which turns X about the vertical and shows in no residual.
///
/// Positions of UTM are told by the size of its numbers, or by fixes of the same drive, from which they are turned by
/// the convergence. Which north the attitudes count from is told by the direction of travel: of an INS that is set up
/// in line with its vehicle, the heading follows it under the right north. What is likelier is taken: attitudes are
/// turned to the grid, and distances divided by its point scale; the rest of the doubt becomes ins_north_sigma_rad,
/// which has in three sigma what the drive cannot tell from it, an INS that is itself turned by about the convergence
/// above all. National grids have numbers like UTM's: where the drive does not speak for UTM, they are left as they
/// are, and what their convergence may be is in the doubt. By fixes their convergence is known, and attitudes are
/// turned by it. Where the grid is not known and the heading keeps an angle from the direction of travel that a
/// convergence may be, that angle is the doubt. Findings "utm-true-north", "utm-grid-north" and "north-unknown".
void settle_north(drive::Session& session);

}  // namespace remount::conventions
