// What registered scans reveal about the recording: clocks that are far apart, angles of the INS in wrong columns.
#pragma once

#include <vector>

#include "model/pipeline.h"
#include "model/pipeline/drive_motion.h"

namespace remount {

/// Where the chained poses of a session's LiDAR turn as the INS did at other times: finding "clock-far" with the
/// offset, and whether leap seconds explain it. Nothing where the offset is one that the solution copes with, or is not
/// clear.
void report_far_clock(const DriveMotion& motion, int session, const std::vector<StampedPose>& first_from_lidar,
                      std::vector<Finding>& findings);

/// Where clocks are too far apart there is no result, whatever was solved, unless the offset was applied: the message
/// and the advice say so, and blame nothing else. Then blame_attitude.
void blame_recording(const std::vector<Finding>& findings, CalibrationResult& result);

/// Compares how INS and LiDAR turned between the scans of every pair that was registered: finding "attitude-columns",
/// where readers have not found the attitude wrong already.
void report_columns(const DriveMotion& motion, PipelineOutput& output);

}  // namespace remount
