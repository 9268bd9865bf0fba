// The keyframes' part of the normal equations: a sparse symmetric matrix of 6x6 blocks.
#pragma once

#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "algorithms/geometry/rigid_transform.h"

namespace remount::calibration {

/// Which blocks of such a matrix are there: of its lower triangle, column by column, and all on its diagonal.
class BlockPattern {
 public:
  using Link = std::pair<std::size_t, std::size_t>;

  /// Links are of two rows of blocks that meet in a term, in any order and as often as they do.
  BlockPattern(std::size_t size, std::vector<Link> links);

  /// Rows of blocks.
  std::size_t size() const { return starts_.size() - 1; }
  /// Blocks.
  std::size_t count() const { return rows_.size(); }
  /// Where a column's first block lies among all; that of the column behind the last is the end.
  std::size_t start(std::size_t column) const { return starts_[column]; }
  /// Ascending; the first is on the diagonal.
  std::span<const std::size_t> rows(std::size_t column) const {
    return {rows_.data() + starts_[column], starts_[column + 1] - starts_[column]};
  }
  /// Where a block lies among all, row >= column. Throws Error(Contract) where it is not there.
  std::size_t place(std::size_t row, std::size_t column) const;

  bool operator==(const BlockPattern&) const = default;

 private:
  std::vector<std::size_t> rows_, starts_;
};

/// Blocks are summed where they lie in memory: as triplets, all their entries would have to be sorted for every noise
/// model that is tried.
class KeyframeBlocks {
 public:
  /// Zero, and without rows.
  KeyframeBlocks() : KeyframeBlocks(BlockPattern(0, {})) {}
  explicit KeyframeBlocks(BlockPattern pattern)
      : pattern_(std::make_shared<const BlockPattern>(std::move(pattern))),
        blocks_(pattern_->count(), Matrix6d::Zero()) {}

  /// Row >= column. Of a block on the diagonal the part above it is not read. Throws Error(Contract) where the pattern
  /// has no such block.
  Matrix6d& at(std::size_t row, std::size_t column) { return blocks_[pattern_->place(row, column)]; }

  const BlockPattern& pattern() const { return *pattern_; }
  /// In the order of the pattern.
  const std::vector<Matrix6d>& blocks() const { return blocks_; }

 private:
  std::shared_ptr<const BlockPattern> pattern_;  // copies differ in their blocks alone
  std::vector<Matrix6d> blocks_;
};

}  // namespace remount::calibration
