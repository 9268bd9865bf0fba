// Clock offsets of the sessions, and how much older their positions are than their attitudes. docs/maths/clocks.md
#pragma once

#include "algorithms/calibration/pairwise/pairwise.h"

namespace remount::calibration {

/// Fills in offsets and lags of a solved problem; nothing where a solution with them does not converge. Where positions
/// and attitudes of an INS differ in age that is estimated beside the offsets: an offset alone would be a mean of both.
/// Sigmas are those of the solution, or what blocks of time scatter where that is more (K12), lags with
/// `doubted_lag_sigma_s`. A lag that does not stand out but is likely is a doubt of X (K14).
void estimate_clock_offset(const PairwiseInput& input, const JointProblem& problem, const PairwiseDetails& details,
                           const Progress& progress, CalibrationResult& result);

/// 1-sigma of a session's lag of which a solution says `sigma_s` and of which `prior_sigma_s` was known before: at an
/// even speed a lag shows in small changes of the velocity alone, which come with what INS and registrations err by, so
/// that the drive says less than the solution believes (K13). Never less than `sigma_s`, never more than the prior.
double doubted_lag_sigma_s(const std::vector<JointNode>& nodes, motion::SessionIndex session, double sigma_s,
                           double prior_sigma_s, bool narrow_field = false);

}  // namespace remount::calibration
