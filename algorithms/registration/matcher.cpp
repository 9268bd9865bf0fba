#include "algorithms/registration/matcher.h"

#include <algorithm>

namespace remount::registration {

FloatTransform float_transform(const RigidTransform& target_from_source) {
  FloatTransform out;
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 3; ++column)
      out.rotation[3 * row + column] = static_cast<float>(target_from_source.linear()(row, column));
    out.translation[row] = static_cast<float>(target_from_source.translation()[row]);
  }
  return out;
}

Matcher::Matcher(const std::vector<PointBlock>& source, const PreparedCloud& target, float radius_m,
                 InstructionSet instructions)
    : source_(source),
      target_(target.tree().view()),
      radius_m_(radius_m),
      kernels_(kernels(instructions)),
      matches_(source.size()),
      scratch_(target.tree().blocks().size()) {
  for (MatchBlock& match : matches_) {
    match = {};
    std::fill_n(match.reach2_m2, kBlockSize, -1.0f);
    std::fill_n(match.index, kBlockSize, -1);
  }
}

void Matcher::update(const RigidTransform& target_from_source, std::int32_t step, const Progress& progress) {
  MatchTask task;
  task.source = source_.data();
  task.matches = matches_.data();
  task.step = step;
  task.target_from_source = float_transform(target_from_source);
  task.radius_m = radius_m_;
  task.scratch = scratch_.data();
  const auto count = static_cast<std::int32_t>(source_.size());
  for (task.first = 0; task.first < count && !progress.cancelled(); task.first += kBlocksAtOnce * step) {
    task.last = std::min(task.first + kBlocksAtOnce * step, count);
    kernels_.match(target_, task);
  }
}

}  // namespace remount::registration
