// Scans that are gathered to one keyframe, where one of them shows too little of what the LiDAR sees.
// docs/maths/pairwise.md (P20)
#pragma once

#include <vector>

#include "algorithms/motion/keyframes.h"
#include "model/pipeline/drive_motion.h"

namespace remount::pipeline {

/// How many frames a keyframe of each session is made of. What successive scans show decides, unless the options say
/// it: a sensor that goes through the same directions in every scan keeps one. Findings tell where it is more, and why.
/// One for each where cancelled.
std::vector<int> choose_gathering(const DriveMotion& motion, const motion::KeyframeOptions& options,
                                  std::vector<drive::Finding>& findings, const Progress& progress);

/// The scans that are gathered to a keyframe, its own first. Without those that a pause of the recording separates.
std::vector<motion::ScanIndex> gathered_scans(const drive::ScanSource& scans, const motion::Keyframe& keyframe,
                                              motion::GatheredFrames frames);

/// A keyframe's pose stands for all its frames: that they lie elsewhere along what the INS drifts by is an error of the
/// keyframe. docs/maths/covariance.md (C33)
void add_drift_within_gathered(const DriveMotion& motion, const std::vector<motion::Keyframe>& keyframes,
                               const std::vector<int>& session_frames, std::vector<calibration::JointNode>& nodes);

/// Gathered scans bear out a share c of what is wrong with the X that they were gathered through. Gathered again and
/// again the error of X is 1 / (1 - c) of what the registrations' own make of it.
double widening_of_gathered(const DriveMotion& motion, const std::vector<int>& session_frames);

}  // namespace remount::pipeline
