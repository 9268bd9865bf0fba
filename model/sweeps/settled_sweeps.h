// Sessions whose format leaves open how their scans were swept, before a method sees them.
#pragma once

#include <vector>

#include "model/pipeline/pipeline.h"

namespace remount::sweeps {

/// What a calibration goes on with.
struct SettledSweeps {
  pipeline::PipelineInput
      input;  ///< sessions whose sweeps were settled are copies, with what was found among their findings
  /// The same with what the scans do not refute either, clocks applied; empty where nothing is open.
  std::vector<pipeline::PipelineInput> others;
};

/// Tries how the scans of each session were swept where that is not known (try_sweeps). Where the scans prove a way, it
/// is taken for granted from here on; otherwise the one that fits best is taken, and the others are to be reckoned
/// with.
SettledSweeps settle_sweeps(const pipeline::PipelineInput& input, Progress& progress);

/// Runs `run` with each of the others, and widens the result by how far X moves.
/// @param run a calibration method, as in CalibrationMethod
void add_sweep_doubts(const SettledSweeps& settled,
                      pipeline::PipelineOutput (*run)(const pipeline::PipelineInput&, Progress&),
                      pipeline::PipelineOutput& output, Progress& progress);

}  // namespace remount::sweeps
