#include "algorithms/calibration/pairwise/bootstrap.h"

#include <map>

namespace remount::calibration {

Matrix6d bootstrap_covariance(const std::vector<BlockPull>& pulls) {
  constexpr std::size_t kFewestBlocks = 4;
  std::map<std::size_t, Vector6d> blocks;
  for (const BlockPull& pull : pulls) blocks.try_emplace(pull.block, Vector6d::Zero()).first->second += pull.step;
  if (blocks.size() < kFewestBlocks) return Matrix6d::Zero();
  const auto count = static_cast<double>(blocks.size());
  Vector6d mean = Vector6d::Zero();
  for (const auto& [block, step] : blocks) mean += step / count;
  Matrix6d covariance = Matrix6d::Zero();
  for (const auto& [block, step] : blocks) covariance += (step - mean) * (step - mean).transpose();
  // Resampling n blocks underestimates by (n - 1) / n.
  return covariance * count / (count - 1.0);
}

}  // namespace remount::calibration
