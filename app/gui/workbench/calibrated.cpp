#include "app/gui/workbench/calibrated.h"

#include <algorithm>

namespace remount {

DecisionKey key_of(const PipelineInput& input, const PipelineOutput& output, const Pair& pair) {
  const Keyframe& a = output.keyframes.at(pair.keyframe_a);
  const Keyframe& b = output.keyframes.at(pair.keyframe_b);
  return {input.sessions.at(a.session)->path.string(), a.stamp_ns, b.stamp_ns};
}

std::optional<PairIndex> same_pair(const PipelineInput& input_before, const PipelineOutput* before,
                                   std::optional<PairIndex> selected, const PipelineInput& input,
                                   const PipelineOutput& output) {
  const auto first = output.pairs.empty() ? std::nullopt : std::optional(PairIndex{0});
  if (!before || !selected || *selected >= before->pairs.size()) return first;
  const DecisionKey wanted = key_of(input_before, *before, before->pairs[*selected]);
  const auto found = std::find_if(output.pairs.begin(), output.pairs.end(),
                                  [&](const Pair& pair) { return key_of(input, output, pair) == wanted; });
  return found == output.pairs.end() ? first : index_at<PairIndex>(found - output.pairs.begin());
}

}  // namespace remount
