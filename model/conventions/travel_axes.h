// Which axis of an INS looks forward.
#pragma once

#include "model/drive/session.h"

namespace remount::conventions {

/// Where the vehicle keeps to another axis of its INS than the one that its format or manifest calls forward, or where
/// neither says, the axes are told by the direction of travel: drivers publish the axes of their box (right, forward,
/// up) under names that mean others, and boxes are built in sideways. Half a turn is told by a speed at which nobody
/// reverses alone. X itself does not change: it is in the axes of the log, whatever they are called. Finding
/// "ins-axes-by-travel". Axes whose z points down are none of those that have a name here: they become unknown, with
/// the finding "ins-axes-down".
void settle_axes(drive::Session& session);

}  // namespace remount::conventions
