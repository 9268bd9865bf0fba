// What the times of a drive are off by, sought until nothing is left, and X solved with it.
#pragma once

#include <cstddef>
#include <vector>

#include "algorithms/calibration/pairwise/pairwise.h"
#include "model/pipeline/drive_motion.h"
#include "model/pipeline/pipeline.h"

namespace remount::pipeline {

inline constexpr double kLeastOffset_s = 0.002;  ///< smaller ones are not worth a word: as an unknown they do no harm
inline constexpr double kHarmlessOffset_s = 1e-4;

/// X with the offsets of the clocks and the lags of positions that stand out taken out, or with what they may do to it
/// in its sigmas. `motion`, the pairs of `output` and `details` are those of the solution afterwards.
calibration::CalibrationResult solve_with_offsets(const PipelineInput& input, DriveMotion& motion,
                                                  PipelineOutput& output, calibration::PairwiseDetails& details,
                                                  const Progress& progress);

/// 1-sigma of a session's offset; of results that do not say, as if all sessions were alike.
double session_sigma_s(const calibration::CalibrationResult& result, std::size_t session);

/// Whether the estimated offset, or that of one session, stands out of its error and is `least_s` at least.
bool any_stands_out(const calibration::CalibrationResult& result, double least_s);
/// Likewise, of those that are worth a word.
bool clock_differs(const calibration::CalibrationResult& result);
/// Whether the drive determines the clocks of a session so well that X loses little where they are unknowns of it: what
/// is too small to stand out is then in its sigma.
bool clock_is_determined(const calibration::CalibrationResult& result);

/// Whether an offset or a lag is taken out of it.
bool is_moved(const DriveMotion& motion);

/// P of every pair as `nodes` have it.
void set_ins_motion(const std::vector<calibration::JointNode>& nodes, std::vector<motion::Pair>& pairs);

/// What another result says of the lags of positions.
void keep_lags(const calibration::CalibrationResult& found, calibration::CalibrationResult& result);

}  // namespace remount::pipeline
