// Points in blocks of sixteen neighbours, and the tree of boxes over them (see kernels.h).
#pragma once

#include <Eigen/Core>
#include <vector>

#include "algorithms/core/progress.h"
#include "algorithms/registration/kernels.h"

namespace remount::registration {

class BlockTree {
 public:
  BlockTree() = default;
  /// Sorts the points by halving them along the longer side of their box, and so on, down to blocks. Empty where
  /// `progress` is cancelled.
  explicit BlockTree(const std::vector<Eigen::Vector3f>& points, const Progress& progress = {});
  BlockTree(BlockTree&&) = default;
  BlockTree& operator=(BlockTree&&) = default;
  BlockTree(const BlockTree&) = delete;
  BlockTree& operator=(const BlockTree&) = delete;

  std::size_t size() const { return size_; }
  std::vector<PointBlock>& blocks() { return blocks_; }
  const std::vector<PointBlock>& blocks() const { return blocks_; }
  BlockTreeView view() const;
  /// Leaves out the points with negative planarity and keeps the order of the others.
  void drop_points_without_surface();
  std::size_t bytes() const;

 private:
  void build_boxes();

  std::vector<PointBlock> blocks_;
  std::vector<BoxNode> nodes_;
  std::vector<std::int32_t> level_begin_;
  std::size_t size_ = 0;
};

}  // namespace remount::registration
