// The keyframes' part of the normal equations: a sparse symmetric matrix of equal square blocks.
#pragma once

#include <Eigen/SparseCore>
#include <utility>
#include <vector>

#include "algorithms/motion/pair.h"

namespace remount::calibration {

/// Of that matrix the lower triangle. Blocks are summed where they lie in memory: as triplets, all their entries would
/// have to be sorted for every noise model that is tried.
class KeyframeBlocks {
 public:
  using Link = std::pair<motion::KeyframeIndex, motion::KeyframeIndex>;
  using Block = Eigen::Map<Eigen::MatrixXd, 0, Eigen::OuterStride<>>;

  /// Zero; links are of keyframes whose unknowns meet in a term, in any order and as often as they do.
  KeyframeBlocks(std::size_t keyframes, int block_size, std::vector<Link> links);

  /// Row and column are keyframes that are linked or the same, row >= column. Valid while this object is. Of a block on
  /// the diagonal the part above it is not read. Throws Error(Contract) for keyframes that are not linked.
  Block at(motion::KeyframeIndex row, motion::KeyframeIndex column);

  /// The matrix as it was summed; the object is of no use afterwards.
  Eigen::SparseMatrix<double> take() {
    Eigen::SparseMatrix<double> matrix;
    matrix.swap(matrix_);  // Eigen's move is a copy
    return matrix;
  }

 private:
  int size_;
  std::vector<motion::KeyframeIndex> rows_;  // of all blocks, column by column
  std::vector<std::size_t> starts_;          // of each column in rows_, and the end
  Eigen::SparseMatrix<double> matrix_;
};

}  // namespace remount::calibration
