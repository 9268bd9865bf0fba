// How many pairs there are of each kind: what every panel that gives a number asks.
#pragma once

#include "model/pipeline/pipeline.h"

namespace remount::widgets {

struct PairCounts {
  int all = 0, accepted = 0, rejected = 0;
  int aligned = 0, by_user = 0;  ///< 0 for methods without pairs
};

/// Of the pairs as they are, decided since the result or not; of methods without pairs, what the result says it used.
PairCounts count_pairs(const pipeline::PipelineOutput& output);

/// What became of the pairs of each session that took part.
struct SessionUse {
  int pairs = 0, accepted = 0, rejected = 0;
  bool unused() const { return rejected == pairs; }  ///< all are judged, and none is accepted
};
std::vector<SessionUse> count_by_session(const pipeline::PipelineOutput& output, std::size_t sessions);

}  // namespace remount::widgets
