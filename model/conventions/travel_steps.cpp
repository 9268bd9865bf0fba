#include "model/conventions/travel_steps.h"

#include <optional>

#include "algorithms/core/stamps.h"
#include "algorithms/geometry/rotation.h"

namespace remount::conventions {
namespace {

constexpr double kSlowest_mps = 2.0, kFastest_mps = 100.0;
constexpr double kWalking_mps = 1.0;

/// Half a second of poses.
struct Block {
  Eigen::Vector3d position = Eigen::Vector3d::Zero();  ///< mean; so is the time
  double time_s = 0.0;
  std::size_t first = 0, last = 0;  ///< of its poses
};

template <class Poses>
std::vector<Block> blocks_of(const Poses& poses) {
  constexpr std::int64_t kBlock_ns = 500'000'000;
  std::vector<Block> blocks;
  std::int64_t number = 0, begin_ns = 0;
  for (std::size_t i = 0; i < poses.size(); ++i) {
    const motion::StampedPose pose = poses[i];
    if (i == 0) begin_ns = pose.stamp_ns;
    const std::int64_t since_ns = pose.stamp_ns - begin_ns, here = since_ns / kBlock_ns;
    if (i == 0 || here != number) blocks.push_back({.first = i});
    number = here;
    Block& block = blocks.back();
    block.position += pose.pose.translation();
    block.time_s += seconds(since_ns);
    block.last = i;
  }
  for (Block& block : blocks) {
    const double count = static_cast<double>(block.last - block.first + 1);
    block.position /= count;
    block.time_s /= count;
  }
  return blocks;
}

/// @param middle index of the pose in the middle
template <class Poses>
std::optional<TravelStep> step_between(const Block& from, const Block& to, std::size_t middle, const Poses& poses,
                                       double slowest_mps) {
  const Eigen::Vector3d step = to.position - from.position;
  const double speed_mps = step.norm() / (to.time_s - from.time_s);
  if (!(speed_mps > slowest_mps && speed_mps < kFastest_mps)) return std::nullopt;
  const motion::StampedPose first = poses[from.first], last = poses[to.last];
  const double turned_rad = so3_log(first.pose.linear().transpose() * last.pose.linear()).z();
  return TravelStep{step.normalized(), speed_mps, poses[middle].pose.linear(),
                    turned_rad / seconds(last.stamp_ns - first.stamp_ns)};
}

/// At a walking pace a whole second, whose halves lead the same way: a receiver that stands wanders to and fro.
template <class Poses>
std::optional<TravelStep> slow_step(const std::vector<Block>& blocks, std::size_t k, const Poses& poses) {
  constexpr double kAlike = 0.7;
  const Block &from = blocks[k - 2], &middle = blocks[k - 1], &to = blocks[k];
  const std::size_t at = (middle.first + middle.last) / 2;
  const Eigen::Vector3d there = middle.position - from.position, on = to.position - middle.position;
  if (there.dot(on) < kAlike * there.norm() * on.norm()) return std::nullopt;
  return step_between(from, to, at, poses, kWalking_mps);
}

template <class Poses>
std::vector<TravelStep> steps_of(const Poses& poses) {
  const std::vector<Block> blocks = blocks_of(poses);
  std::vector<TravelStep> steps;
  std::size_t reached = 0;
  for (std::size_t k = 1; k < blocks.size(); ++k) {
    std::optional<TravelStep> step = step_between(blocks[k - 1], blocks[k], blocks[k - 1].last, poses, kSlowest_mps);
    if (!step && k >= reached + 2) step = slow_step(blocks, k, poses);
    if (!step) continue;
    steps.push_back(*step);
    reached = k;
  }
  return steps;
}

}  // namespace

std::vector<TravelStep> travel_steps(const std::vector<motion::StampedPose>& world_from_ins) {
  return steps_of(world_from_ins);
}

std::vector<TravelStep> travel_steps(const MetricPoses& world_from_ins) { return steps_of(world_from_ins); }

}  // namespace remount::conventions
