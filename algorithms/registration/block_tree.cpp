#include "algorithms/registration/block_tree.h"

#include <algorithm>
#include <bit>

namespace remount::registration {
namespace {

constexpr auto kBlock = static_cast<std::size_t>(kBlockSize);

using PointIterator = std::vector<Eigen::Vector3f>::iterator;

// The left part gets the largest power of two of blocks below the whole, so that eight consecutive blocks (and eight of
// these, ...) are what three halvings made.
void sort_spatially(PointIterator begin, PointIterator end, const Progress& progress) {
  const auto count = static_cast<std::size_t>(end - begin);
  if (count <= kBlock || progress.cancelled()) return;
  Eigen::Vector3f low = *begin, high = *begin;
  for (auto point = begin; point != end; ++point) {
    low = low.cwiseMin(*point);
    high = high.cwiseMax(*point);
  }
  Eigen::Index axis = 0;
  (high - low).maxCoeff(&axis);
  const std::size_t blocks = (count + kBlock - 1) / kBlock;
  const auto middle = begin + static_cast<std::ptrdiff_t>(kBlock * std::bit_floor(blocks - 1));
  std::nth_element(begin, middle, end,
                   [axis](const Eigen::Vector3f& a, const Eigen::Vector3f& b) { return a[axis] < b[axis]; });
  sort_spatially(begin, middle, progress);
  sort_spatially(middle, end, progress);
}

PointBlock empty_block() {
  PointBlock block{};
  std::fill_n(block.x, kBlockSize, kFarAway_m);
  std::fill_n(block.y, kBlockSize, kFarAway_m);
  std::fill_n(block.z, kBlockSize, kFarAway_m);
  std::fill_n(block.nz, kBlockSize, 1.0f);
  return block;
}

BoxNode empty_node() {
  BoxNode node;
  std::fill_n(&node.low[0][0], 24, kFarAway_m);
  std::fill_n(&node.high[0][0], 24, -kFarAway_m);
  return node;
}

void widen(BoxNode& node, std::size_t child, int axis, float low, float high) {
  node.low[axis][child] = std::min(node.low[axis][child], low);
  node.high[axis][child] = std::max(node.high[axis][child], high);
}

}  // namespace

BlockTree::BlockTree(const std::vector<Eigen::Vector3f>& points, const Progress& progress) {
  std::vector<Eigen::Vector3f> sorted = points;
  sort_spatially(sorted.begin(), sorted.end(), progress);
  if (progress.cancelled()) return;
  size_ = sorted.size();
  blocks_.assign((size_ + kBlock - 1) / kBlock, empty_block());
  for (std::size_t i = 0; i < size_; ++i) {
    PointBlock& block = blocks_[i / kBlock];
    block.x[i % kBlock] = sorted[i].x();
    block.y[i % kBlock] = sorted[i].y();
    block.z[i % kBlock] = sorted[i].z();
  }
  build_boxes();
}

void BlockTree::build_boxes() {
  nodes_.clear();
  level_begin_.clear();
  if (blocks_.empty()) return;
  level_begin_.push_back(0);
  nodes_.assign((blocks_.size() + 7) / 8, empty_node());
  for (std::size_t i = 0; i < size_; ++i) {
    const PointBlock& block = blocks_[i / kBlock];
    const float* coordinates[3] = {block.x, block.y, block.z};
    for (int axis = 0; axis < 3; ++axis) {
      const float v = coordinates[axis][i % kBlock];
      widen(nodes_[i / (8 * kBlock)], i / kBlock % 8, axis, v, v);
    }
  }
  for (std::size_t begin = 0, count = nodes_.size(); count > 1;) {
    const std::size_t next = begin + count, parents = (count + 7) / 8;
    level_begin_.push_back(static_cast<std::int32_t>(next));
    nodes_.resize(next + parents, empty_node());
    for (std::size_t i = 0; i < count; ++i)
      for (int axis = 0; axis < 3; ++axis)
        for (std::size_t child = 0; child < 8; ++child)
          widen(nodes_[next + i / 8], i % 8, axis, nodes_[begin + i].low[axis][child],
                nodes_[begin + i].high[axis][child]);
    begin = next;
    count = parents;
  }
}

BlockTreeView BlockTree::view() const {
  BlockTreeView view;
  view.blocks = blocks_.data();
  view.nodes = nodes_.data();
  view.levels = static_cast<std::int32_t>(level_begin_.size());
  view.block_count = static_cast<std::int32_t>(blocks_.size());
  std::copy(level_begin_.begin(), level_begin_.end(), view.level_begin);
  return view;
}

void BlockTree::drop_points_without_surface() {
  std::size_t kept = 0;
  const std::vector<PointBlock> all = blocks_;
  for (std::size_t i = 0; i < size_; ++i) {
    const PointBlock& from = all[i / kBlock];
    const std::size_t k = i % kBlock;
    if (from.planarity[k] < 0.0f) continue;
    if (kept % kBlock == 0) blocks_[kept / kBlock] = empty_block();
    PointBlock& to = blocks_[kept / kBlock];
    const std::size_t at = kept++ % kBlock;
    to.x[at] = from.x[k], to.y[at] = from.y[k], to.z[at] = from.z[k];
    to.nx[at] = from.nx[k], to.ny[at] = from.ny[k], to.nz[at] = from.nz[k];
    to.planarity[at] = from.planarity[k];
  }
  size_ = kept;
  blocks_.resize((kept + kBlock - 1) / kBlock, empty_block());
  blocks_.shrink_to_fit();
  build_boxes();
}

std::size_t BlockTree::bytes() const {
  return blocks_.capacity() * sizeof(PointBlock) + nodes_.capacity() * sizeof(BoxNode);
}

}  // namespace remount::registration
