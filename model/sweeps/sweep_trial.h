// How the points of a session's scans were swept, where the format does not say: told by the scans themselves.
// docs/maths/sweeps.md (W4) to (W6)
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "algorithms/cloud/sweep_order.h"
#include "algorithms/core/progress.h"
#include "model/drive/session.h"
#include "model/settings/settings.h"

namespace remount::sweeps {

/// One way in which scans may have been taken; nothing: at once, or compensated already.
using SweepGuess = std::optional<drive::SweepModel>;

/// What is left between each scan and the map before it, with one guess: the logarithm of the distance.
struct TriedSweep {
  SweepGuess guess;
  std::vector<double> residuals;
};

struct SweepTrial {
  bool proved = false;             ///< `best` fits the scans clearly better than all that was tried besides
  SweepGuess best;                 ///< fits them best
  std::vector<SweepGuess> others;  ///< those that the scans do not refute: ways and times of a turn
  std::vector<TriedSweep> tried;   ///< the best of each way and length of a sweep
  double gain = 0.0;  ///< how much less `best` leaves as residual than the next of another kind, as a share
};

/// Whether the scans of a session leave open how they were swept, as far as the settings ask.
bool needs_sweep_trial(const drive::Session& session, settings::DeskewMode mode);

/// Runs the LiDAR's own odometry over the stretch of scans that turns most, once for each way in which they may have
/// been swept, and compares what is left between each scan and the map before it. Needs no INS and no mounting. Tried
/// are: no sweep (unless the format says that there is one), both directions of turning (unless it says which), where
/// nothing is said of the sweep the azimuth at which it begins too, and the order of the points for sensors that do not
/// spin. Scans that cannot be read are passed over. Not proved where cancelled.
SweepTrial try_sweeps(const drive::Session& session, const settings::Settings& settings, int threads,
                      Progress& progress);

/// Sessions of which none proves anything for itself are judged together, where the same ways were tried of each: one
/// LiDAR is recorded in one way.
void prove_together(const std::vector<SweepTrial*>& trials);

}  // namespace remount::sweeps
