#include "app/gui/workbench/calibrated.h"

#include <algorithm>

namespace remount {

DecisionKey key_of(const PipelineInput& input, const PipelineOutput& output, const Pair& pair) {
  const Keyframe& a = output.keyframes.at(static_cast<std::size_t>(pair.keyframe_a));
  const Keyframe& b = output.keyframes.at(static_cast<std::size_t>(pair.keyframe_b));
  return {input.sessions.at(static_cast<std::size_t>(a.session))->path.string(), a.stamp_ns, b.stamp_ns};
}

int same_pair(const PipelineInput& input_before, const PipelineOutput* before, int selected, const PipelineInput& input,
              const PipelineOutput& output) {
  const int first = output.pairs.empty() ? -1 : 0;
  if (!before || selected < 0 || selected >= std::ssize(before->pairs)) return first;
  const DecisionKey wanted = key_of(input_before, *before, before->pairs[static_cast<std::size_t>(selected)]);
  const auto found = std::find_if(output.pairs.begin(), output.pairs.end(),
                                  [&](const Pair& pair) { return key_of(input, output, pair) == wanted; });
  return found == output.pairs.end() ? first : static_cast<int>(found - output.pairs.begin());
}

}  // namespace remount
