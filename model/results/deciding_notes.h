// Notes that a result rests on: what the program decided on its own, and could have decided otherwise.
#pragma once

#include <array>
#include <string_view>

#include "model/drive/session.h"

namespace remount::results {

/// Of scans that do not tell the motion.
inline constexpr const char* kOdometryByWheels = "odometry-by-wheels";
/// Which of several recordings was taken for which.
inline constexpr const char* kRecording = "recording";

/// Keyframes lie closer together than the settings ask for, so that there are enough.
inline constexpr const char* kCloserKeyframes = "keyframes-closer";

/// Several scans make a keyframe, for one shows too little.
inline constexpr const char* kScansGathered = "scans-gathered";
/// Of many pairs those were registered that tell most.
inline constexpr const char* kPairsChosen = "pairs-chosen";
/// Errors of the LiDAR's beams were found and are taken out of its scans.
inline constexpr const char* kMendedBeams = "beam-errors";

/// Codes of such notes.
inline constexpr std::array<std::string_view, 34> kDecidingNotes{
    // of methods: what was taken for what, what stands in for what is missing, and where scans do not tell the motion
    kRecording, kOdometryByWheels, kCloserKeyframes, kScansGathered, kPairsChosen, kMendedBeams, "odometry-without",
    "odometry-deskew-off", "odometry-undetermined", "deskew-on", "deskew-off", "imu-from-ins", "trajectory-outliers",
    "trajectory-fixes", "nominal-unused", "clock-open", "ins-positions-apart",
    // of readers: which of several streams was taken, and what was assumed of it
    "topic-chosen", "lidar-chosen", "ins-file-chosen", "ins-log-chosen", "scans-preferred", "lidar-poses-preferred",
    "attitude-chosen", "stamps-by-number", "stamps-unit", "utm-grid-north", "ins-axes-by-travel", "one-speed",
    "truth-as-gnss", "gnss-sigma-assumed", "gnss-covariance-unknown", "host-clock", "clock-aligned"};

/// Whether a finding belongs into the result file and its summary although it is a note. Other notes are for the log.
bool is_deciding(const drive::Finding& finding);

}  // namespace remount::results
