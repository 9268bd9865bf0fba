// Clock offsets of the sessions, and how much older their positions are than their attitudes. docs/maths/clocks.md
#pragma once

#include "algorithms/calibration/pairwise/pairwise.h"

namespace remount::calibration {

/// Fills in offsets and lags of a solved problem; nothing where a solution with them does not converge. Where positions
/// and attitudes of an INS differ in age that is estimated beside the offsets: an offset alone would be a mean of both.
/// Sigmas are those of the solution, or what blocks of time scatter where that is more (K12), with `lag_doubt`.
void estimate_clock_offset(const PairwiseInput& input, const JointProblem& problem, const PairwiseDetails& details,
                           const Progress& progress, CalibrationResult& result);

/// How many times as large as the solution says is the error of a session's lag, 1 or more: at an even speed a lag
/// shows in small changes of the velocity alone, which come with what the INS and the registrations err by (K13).
double lag_doubt(const std::vector<JointNode>& nodes, motion::SessionIndex session);

}  // namespace remount::calibration
