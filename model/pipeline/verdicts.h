// A user's decisions about pairs, named by what outlives a calibration: the stamps of the two scans.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "algorithms/motion/pair.h"

namespace remount::pipeline {

struct PipelineOutput;

struct PairVerdict {
  motion::SessionIndex session;
  std::int64_t stamp_a_ns = 0, stamp_b_ns = 0;
  motion::PairState state = motion::PairState::Proposed;
  Message reason;
};

/// Gives the pairs of an output the states of the verdicts, as decided by the user; a solution makes them count.
/// What cannot be used is not accepted, whatever was decided about an earlier registration. Returns how many verdicts
/// found their pair.
int apply_verdicts(const std::vector<PairVerdict>& verdicts, PipelineOutput& output);

/// The program judges all pairs again that the user had decided; none that no solution can use.
void withdraw_verdicts(PipelineOutput& output);

}  // namespace remount::pipeline
