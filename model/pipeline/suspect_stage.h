// What registered scans reveal about the recording: clocks that are far apart, angles of the INS in wrong columns.
#pragma once

#include <optional>
#include <vector>

#include "model/pipeline/drive_motion.h"
#include "model/pipeline/pipeline.h"

namespace remount::pipeline {

/// An offset of a session's clocks that the solution does not cope with, and the finding "clock-far" that names it.
struct FarClock {
  motion::SessionIndex session;
  double offset_s = 0.0;  ///< t_ins = t_lidar + offset
  drive::Finding finding;
};

/// Where the chained poses of a session's LiDAR turn as the INS did at other times, and whether leap seconds explain
/// it. Nothing where the offset is one that the solution copes with, or is not clear.
std::optional<FarClock> find_far_clock(const DriveMotion& motion, motion::SessionIndex session,
                                       const std::vector<motion::StampedPose>& first_from_lidar);

/// Findings of clocks that are far apart, as the registered pairs see it: of those `found` in chained scans, which a
/// log with faults can mislead, what they do not refute; of recordings that lie apart by leap seconds
/// ("clock-leap-seconds"), what they confirm.
void report_far_clocks(const DriveMotion& motion, const std::vector<FarClock>& found, PipelineOutput& output);

/// Where clocks are too far apart there is no result, whatever was solved, unless that offset was applied: the message
/// and the advice say so, and blame nothing else. Then blame_attitude.
void blame_recording(const std::vector<drive::Finding>& findings, calibration::CalibrationResult& result,
                     double farthest_clock_s = 0.0);

/// Compares how INS and LiDAR turned between the scans of every pair that was registered: finding "attitude-columns",
/// where readers have not found the attitude wrong already.
void report_columns(const DriveMotion& motion, PipelineOutput& output);

}  // namespace remount::pipeline
