// The hold-out check: X solved on one session, scored on the pairs of another that had no say in it.
#pragma once

#include <array>
#include <vector>

#include "algorithms/calibration/agreement.h"
#include "model/pipeline/pipeline.h"

namespace remount::pipeline {

/// What P X = X Q leaves over the pairs of a session under some X, root mean square; NaN where there is no such X.
struct ResidualRms {
  double rotation_rad = std::numeric_limits<double>::quiet_NaN();
  double translation_m = std::numeric_limits<double>::quiet_NaN();
};

/// One session solved from its own pairs alone.
struct SessionAlone {
  calibration::CalibrationResult result;  ///< without candidates; where nothing may be used, its message says why
  int pairs = 0;                          ///< those its own solution accepts, or else the common one: what is scored
  ResidualRms own;                        ///< of these under its own X
  ResidualRms common;                     ///< of these under the X of all sessions
};

/// The pairs of one session under the X of another.
struct HeldOutScore {
  motion::SessionIndex solved_on, scored_on;
  ResidualRms residual;
  /// Components that the first session does not observe: taken from the second one's own X, they are neither to be
  /// praised nor to be blamed on the first.
  calibration::ParameterSet lent;
};

/// X of session a against X of session b.
struct SessionDifference : calibration::ResultDifference {
  motion::SessionIndex a, b;
};

struct HoldOut {
  std::vector<SessionAlone> sessions;          ///< in the order of the input
  std::vector<HeldOutScore> scores;            ///< every session under the X of every other one
  std::vector<SessionDifference> differences;  ///< every two sessions once
};

/// Solves each session again from its registered pairs: the user's decisions hold, the program's are taken anew, for it
/// took them with the help of the other sessions. What was measured by hand is left out: given to all, it is no
/// agreement. No scan is read. Empty with fewer than two sessions, and where cancelled.
HoldOut check_hold_out(const PipelineInput& input, const PipelineOutput& output, Progress& progress);

}  // namespace remount::pipeline
