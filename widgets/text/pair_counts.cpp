#include "widgets/text/pair_counts.h"

#include "algorithms/motion/pair.h"
#include "widgets/basics/rows.h"

namespace remount::widgets {

PairCounts count_pairs(const pipeline::PipelineOutput& output) {
  const calibration::CalibrationResult& result = output.result;
  if (output.pairs.empty()) return {result.pairs_proposed, result.pairs_accepted, result.pairs_rejected, 0, 0};
  PairCounts counts;
  counts.all = qt_count(output.pairs.size());
  for (const motion::Pair& pair : output.pairs) {
    counts.aligned += motion::unusable_reason(pair).empty();
    counts.accepted += pair.state == motion::PairState::Accepted;
    counts.rejected += pair.state == motion::PairState::Rejected;
    counts.by_user += pair.decided_by == motion::DecidedBy::User;
  }
  return counts;
}

std::vector<SessionUse> count_by_session(const pipeline::PipelineOutput& output, std::size_t sessions) {
  std::vector<SessionUse> uses(sessions);
  for (const motion::Pair& pair : output.pairs) {
    const motion::SessionIndex of = output.keyframes.at(pair.keyframe_a).session;
    if (of >= sessions) continue;
    ++uses[of].pairs;
    uses[of].accepted += pair.state == motion::PairState::Accepted;
    uses[of].rejected += pair.state == motion::PairState::Rejected;
  }
  return uses;
}

}  // namespace remount::widgets
