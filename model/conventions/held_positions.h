// Positions of an INS that are logged more often than they are computed, beside attitudes that are not.
#pragma once

#include <optional>

#include "algorithms/geometry/rotation.h"
#include "model/conventions/held_values.h"
#include "model/drive/session.h"

namespace remount::conventions {

/// Values count where the vehicle turns or drives by more than this within a second.
inline constexpr double kTurning_rad = 3.0 * kPi / 180.0, kDriving_m = 1.0;
/// What jumps by less may be rounding of the log; it moves nothing that is calibrated.
inline constexpr double kLeastTurn_rad = 0.15 * kPi / 180.0, kLeastStep_m = 0.1;
/// Interpolating between two attitudes that are the same rounds.
inline constexpr double kSameAttitude_rad = 1e-8;

/// How the places of a session stand still and jump; nothing where they do not. Heights may come from elsewhere.
/// @param poses of the session
std::optional<HeldSteps> held_positions(const drive::Session& session, const MetricPoses& poses);

inline constexpr const char* kPositionsInterpolated = "ins-positions-interpolated";

/// A position that repeats the one before is no measurement of where the vehicle is by then. Where positions are held
/// evenly while the vehicle drives, only the first sample of each counts as measured (Session::ins_fix_stamps_ns);
/// between these positions lie on a cubic through the neighbours, and attitudes stay as they were logged. Where
/// attitudes are held with them, the repeats are left out. Finding "ins-positions-interpolated". Left as they are, for
/// a check to name: holds of uneven lengths, and attitudes that are held for another time than the positions.
void interpolate_held_positions(drive::Session& session);

}  // namespace remount::conventions
