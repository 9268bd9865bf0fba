#include "app/gui/workbench/calibrated.h"

#include <algorithm>

namespace remount::gui {

DecisionKey key_of(const pipeline::PipelineInput& input, const pipeline::PipelineOutput& output,
                   const motion::Pair& pair) {
  const motion::Keyframe& a = output.keyframes.at(pair.keyframe_a);
  const motion::Keyframe& b = output.keyframes.at(pair.keyframe_b);
  return {input.sessions.at(a.session)->path.string(), a.stamp_ns, b.stamp_ns};
}

std::optional<motion::PairIndex> same_pair(const pipeline::PipelineInput& input_before,
                                           const pipeline::PipelineOutput* before,
                                           std::optional<motion::PairIndex> selected,
                                           const pipeline::PipelineInput& input,
                                           const pipeline::PipelineOutput& output) {
  const auto first = output.pairs.empty() ? std::nullopt : std::optional(motion::PairIndex{0});
  if (!before || !selected || *selected >= before->pairs.size()) return first;
  const DecisionKey wanted = key_of(input_before, *before, before->pairs[*selected]);
  const auto found = std::find_if(output.pairs.begin(), output.pairs.end(),
                                  [&](const motion::Pair& pair) { return key_of(input, output, pair) == wanted; });
  return found == output.pairs.end() ? first : index_at<motion::PairIndex>(found - output.pairs.begin());
}

}  // namespace remount::gui
