#include "widgets/text/pair_counts.h"

#include "algorithms/motion/pair.h"
#include "widgets/basics/rows.h"

namespace remount {

PairCounts count_pairs(const PipelineOutput& output) {
  const CalibrationResult& result = output.result;
  if (output.pairs.empty()) return {result.pairs_proposed, result.pairs_accepted, result.pairs_rejected, 0, 0};
  PairCounts counts;
  counts.all = qt_count(output.pairs.size());
  for (const Pair& pair : output.pairs) {
    counts.aligned += unusable_reason(pair).empty();
    counts.accepted += pair.state == PairState::Accepted;
    counts.rejected += pair.state == PairState::Rejected;
    counts.by_user += pair.decided_by == DecidedBy::User;
  }
  return counts;
}

std::vector<SessionUse> count_by_session(const PipelineOutput& output, std::size_t sessions) {
  std::vector<SessionUse> uses(sessions);
  for (const Pair& pair : output.pairs) {
    const SessionIndex of = output.keyframes.at(pair.keyframe_a).session;
    if (of >= sessions) continue;
    ++uses[of].pairs;
    uses[of].accepted += pair.state == PairState::Accepted;
    uses[of].rejected += pair.state == PairState::Rejected;
  }
  return uses;
}

}  // namespace remount
