// From registered pairs to X, with the clock offset between lidar and INS.
#pragma once

#include "algorithms/calibration/pairwise/pairwise.h"
#include "model/pipeline/drive_motion.h"
#include "model/pipeline/pipeline.h"
#include "model/pipeline/shared_field.h"

namespace remount::pipeline {

/// The INS motion at the clock offsets, and without the lags of its positions, that the last solution applied.
DriveMotion motion_as_solved(const PipelineInput& input, const PipelineOutput& output);

/// Where errors of the LiDAR's beams are unknowns. Throws Error(Contract) where those that are known are of another
/// kind of field.
cloud::BeamNodes choose_beam_nodes(const PipelineInput& input, const SharedField& field,
                                   const cloud::BeamEstimate& known);

/// What is believed of the errors of the LiDAR's beams: as a file of them says, as the settings say, or as all sessions
/// with scans agree.
cloud::BeamPrior beams_believed(const PipelineInput& input, const PipelineOutput& output);

/// The solver's input for the keyframes of `output` at the present clock offsets of `motion`.
calibration::PairwiseInput solver_input(const PipelineInput& input, const DriveMotion& motion,
                                        const PipelineOutput& output);

/// Solves the pairs of `output` and estimates the clock offset to convergence. Where it is clear, or the settings ask
/// for it, the offset is applied: to `motion`, to P of every pair and to the result. What was found and is not applied
/// is reported, and how far it biases X goes into `output` and the sigmas.
calibration::CalibrationResult solve_with_clock(const PipelineInput& input, DriveMotion& motion, PipelineOutput& output,
                                                calibration::PairwiseDetails& details, const Progress& progress);

/// Takes an estimate of the clocks out of a result: where X is wrong, or where scans may be bent by their motion, which
/// looks like an offset and is none.
void drop_clock(calibration::CalibrationResult& result);

/// Only the offsets of the clocks: where scans do not tell when they were taken.
void drop_offsets(calibration::CalibrationResult& result);

/// What another result says of the clocks.
void keep_clock(const calibration::CalibrationResult& found, calibration::CalibrationResult& result);

/// Widens a result by how far X moves where the scans were swept otherwise than was taken, and says so.
void doubt_sweeps(const std::vector<Vector6d>& doubts, const calibration::SolveOptions& options,
                  calibration::CalibrationResult& result);

/// Status and message of a solved result after a doubt, which may have left less of it, or nothing.
void judge_again(const Message& nothing_known, calibration::CalibrationResult& result);

inline constexpr const char* kClockOffset = "clock-offset";
/// A finding for each session whose offset stands out: a note where X is solved with it, a warning where it is not.
void report_clock(const PipelineInput& input, const calibration::CalibrationResult& result,
                  std::vector<drive::Finding>& findings);

/// The same for pairs that were solved before: an offset that was applied stays as it was found then, unless the
/// settings no longer ask for it.
calibration::CalibrationResult solve_with_clock_again(const PipelineInput& input, PipelineOutput& output,
                                                      calibration::PairwiseDetails& details, const Progress& progress);

}  // namespace remount::pipeline
