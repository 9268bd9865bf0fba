#include "model/pipeline/verdicts.h"

#include <map>
#include <tuple>

#include "model/pipeline/pipeline.h"

namespace remount::pipeline {

int apply_verdicts(const std::vector<PairVerdict>& verdicts, PipelineOutput& output) {
  if (verdicts.empty()) return 0;
  std::map<std::tuple<motion::SessionIndex, std::int64_t, std::int64_t>, const PairVerdict*> wanted;
  for (const PairVerdict& verdict : verdicts)
    wanted[{verdict.session, verdict.stamp_a_ns, verdict.stamp_b_ns}] = &verdict;
  int applied = 0;
  for (motion::Pair& pair : output.pairs) {
    const motion::Keyframe& a = output.keyframes.at(pair.keyframe_a);
    const motion::Keyframe& b = output.keyframes.at(pair.keyframe_b);
    const auto found = wanted.find({a.session, a.stamp_ns, b.stamp_ns});
    if (found == wanted.end()) continue;
    if (found->second->state == motion::PairState::Accepted && !motion::unusable_reason(pair).empty()) continue;
    pair.state = found->second->state;
    pair.reason = found->second->reason;
    pair.decided_by = motion::DecidedBy::User;
    ++applied;
  }
  return applied;
}

void withdraw_verdicts(PipelineOutput& output) {
  for (motion::Pair& pair : output.pairs) {
    if (pair.decided_by != motion::DecidedBy::User) continue;
    const Message unusable = motion::unusable_reason(pair);
    pair.state = unusable.empty() ? motion::PairState::Proposed : motion::PairState::Rejected;
    pair.decided_by = unusable.empty() ? motion::DecidedBy::Nobody : motion::DecidedBy::Program;
    pair.reason = unusable;
  }
}

}  // namespace remount::pipeline
