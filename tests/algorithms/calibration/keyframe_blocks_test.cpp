#include "algorithms/calibration/keyframe_blocks.h"

#include <gtest/gtest.h>

#include <Eigen/Dense>

namespace remount {
namespace {

TEST(keyframe_blocks, lie_where_a_dense_matrix_has_them) {
  constexpr int kKeyframes = 5, kSize = 3;
  // As terms name them: twice, and the later keyframe first or last.
  KeyframeBlocks blocks(kKeyframes, kSize, {{0, 3}, {3, 0}, {4, 1}, {0, 1}, {2, 2}});
  Eigen::MatrixXd dense = Eigen::MatrixXd::Zero(kKeyframes * kSize, kKeyframes * kSize);
  int number = 0;
  for (const auto& [row, column] : {std::pair{3, 0}, {1, 0}, {3, 0}, {4, 1}, {0, 0}, {2, 2}, {4, 4}}) {
    const Eigen::MatrixXd part =
        Eigen::MatrixXd::NullaryExpr(kSize, kSize, [&](Eigen::Index, Eigen::Index) { return ++number; });
    blocks.at(row, column) += part;
    dense.block(row * kSize, column * kSize, kSize, kSize) += part;
  }
  const Eigen::SparseMatrix<double> matrix = blocks.take();
  EXPECT_EQ(Eigen::MatrixXd(matrix), dense);
  EXPECT_EQ(matrix.nonZeros(), (kKeyframes + 3) * kSize * kSize);
  for (int column = 0; column < matrix.cols(); ++column)
    for (Eigen::SparseMatrix<double>::InnerIterator entry(matrix, column), before(matrix, column); ++entry; ++before)
      EXPECT_GT(entry.row(), before.row()) << "column " << column;
}

TEST(keyframe_blocks, of_no_keyframes_are_an_empty_matrix) { EXPECT_EQ(KeyframeBlocks(0, 6, {}).take().size(), 0); }

}  // namespace
}  // namespace remount
