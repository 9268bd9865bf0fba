// Positions of poses that are no metres of a flat world.
#pragma once

#include "model/drive/session.h"

namespace remount::conventions {

/// Refuses latitude, longitude and height as x, y, z of the INS's poses, in degrees or radians and in either order, and
/// earth-centred coordinates (ECEF): a drive of a kilometre would be one of a centimetre, or lie on its side. Degrees
/// are told by how slowly they change beside what else moves: no vehicle that turns, climbs or carries a LiDAR that
/// moves travels by micrometres a second. Throws Error(Format) that says what to do.
void refuse_foreign_units(const drive::Session& session);

}  // namespace remount::conventions
