// Poses that are of a plane, though the vehicle drives on the earth.
#pragma once

#include "model/drive/session.h"

namespace remount::conventions {

inline constexpr const char* kPosesInPlane = "poses-in-plane";

/// Poses of an INS that all have the same height, however far they lead, or that are level to all digits, were made in
/// a plane: by wheels, by a localisation in a map, by a planar SLAM. What is not in them is open, as in a log of
/// headings alone: roll and pitch by kAssumedTilt_rad, for a way that climbs is level in them (also where the attitude
/// tilts and the height stays, since then the two contradict each other), and heights by what such a slope makes of the
/// way. Sets Session::ins_tilt_sigma_rad and unmeasured_height_sigma_m, with the warning "poses-in-plane".
void settle_plane(drive::Session& session);

}  // namespace remount::conventions
