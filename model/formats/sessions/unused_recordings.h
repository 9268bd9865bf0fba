// Recordings beside a log that could have held the LiDAR, and give nothing.
#pragma once

#include "model/drive/session.h"

namespace remount::formats {

/// Where a folder was read as a session without a LiDAR, adds "recording-unused" of each capture or bag beside, with
/// its reason.
void tell_unused_recordings(drive::Session& session);

}  // namespace remount::formats
