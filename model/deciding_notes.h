// Notes that a result rests on: what the program decided on its own, and could have decided otherwise.
#pragma once

#include "model/session.h"

namespace remount {

/// Of scans that do not tell the motion.
inline constexpr const char* kOdometryByWheels = "odometry-by-wheels";
/// Which of several recordings was taken for which.
inline constexpr const char* kRecording = "recording";

/// Keyframes lie closer together than the settings ask for, so that there are enough.
inline constexpr const char* kCloserKeyframes = "keyframes-closer";

/// Whether a finding belongs into the result file and its summary although it is a note. Other notes are for the log.
bool is_deciding(const Finding& finding);

}  // namespace remount
