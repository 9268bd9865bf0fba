#include "model/travel_steps.h"

namespace remount {

std::vector<TravelStep> travel_steps(const std::vector<StampedPose>& world_from_ins) {
  constexpr std::int64_t kBlock_ns = 500'000'000;
  constexpr double kSlowest_mps = 2.0, kFastest_mps = 100.0;
  const std::vector<StampedPose>& poses = world_from_ins;
  struct Block {
    Eigen::Vector3d position = Eigen::Vector3d::Zero();
    double count = 0.0, time_s = 0.0;
    std::size_t last = 0;
  };
  std::vector<Block> blocks;
  std::int64_t number = 0;
  for (std::size_t i = 0; i < poses.size(); ++i) {
    const std::int64_t here = (poses[i].stamp_ns - poses.front().stamp_ns) / kBlock_ns;
    if (i == 0 || here != number) blocks.emplace_back();
    number = here;
    Block& block = blocks.back();
    block.position += poses[i].pose.translation();
    block.time_s += static_cast<double>(poses[i].stamp_ns - poses.front().stamp_ns) * 1e-9;
    block.count += 1.0;
    block.last = i;
  }
  std::vector<TravelStep> steps;
  for (std::size_t k = 1; k < blocks.size(); ++k) {
    const Block &from = blocks[k - 1], &to = blocks[k];
    const Eigen::Vector3d step = to.position / to.count - from.position / from.count;
    const double from_s = from.time_s / from.count, to_s = to.time_s / to.count;
    const double speed_mps = step.norm() / (to_s - from_s);
    if (speed_mps > kSlowest_mps && speed_mps < kFastest_mps)
      steps.push_back({0.5 * (from_s + to_s), step.normalized(), speed_mps, poses[from.last].pose.linear()});
  }
  return steps;
}

}  // namespace remount
