// Nearest neighbours of all points of one scan in another, kept from one transform to the next where they provably
// stay.
#pragma once

#include <vector>

#include "algorithms/core/progress.h"
#include "algorithms/geometry/rigid_transform.h"
#include "algorithms/registration/prepared_cloud.h"

namespace remount::registration {

FloatTransform float_transform(const RigidTransform& target_from_source);

/// Blocks are worked on a few hundred at a time, with a look at the progress in between.
inline constexpr std::int32_t kBlocksAtOnce = 256;

/// Finds the neighbours of one scan's blocks in another scan.
/// Keeps references to `source`, to the blocks of `target` and to nothing else: both must outlive it and stay
/// unchanged. One matcher serves one pair on one thread.
class Matcher {
 public:
  Matcher(const std::vector<PointBlock>& source, const PreparedCloud& target, float radius_m,
          InstructionSet instructions);

  /// Neighbours at this transform of every `step`-th block of the source; those of the other blocks stay as they were
  /// last searched. Incomplete where `progress` is cancelled.
  void update(const RigidTransform& target_from_source, std::int32_t step, const Progress& progress);
  /// One a block of the source, as of the last update. Valid as long as the matcher.
  const std::vector<MatchBlock>& matches() const { return matches_; }
  float radius_m() const { return radius_m_; }

 private:
  const std::vector<PointBlock>& source_;
  BlockTreeView target_;
  float radius_m_;
  const Kernels& kernels_;
  std::vector<MatchBlock> matches_;
  std::vector<std::int32_t> scratch_;
};

}  // namespace remount::registration
