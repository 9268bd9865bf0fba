#include "algorithms/calibration/joint/keyframe_blocks.h"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <Eigen/SparseCholesky>

#include "algorithms/core/error.h"

namespace remount::calibration {
namespace {

KeyframeBlocks::Link link(int a, int b) {
  return {index_at<motion::KeyframeIndex>(a), index_at<motion::KeyframeIndex>(b)};
}

TEST(keyframe_blocks, lie_where_a_dense_matrix_has_them) {
  constexpr int kKeyframes = 5, kSize = 3;
  // As terms name them: twice, and the later keyframe first or last.
  KeyframeBlocks blocks(kKeyframes, kSize, {link(0, 3), link(3, 0), link(4, 1), link(0, 1), link(2, 2)});
  Eigen::MatrixXd dense = Eigen::MatrixXd::Zero(kKeyframes * kSize, kKeyframes * kSize);
  int number = 0;
  for (const auto& [row, column] : {std::pair{3, 0}, {1, 0}, {3, 0}, {4, 1}, {0, 0}, {2, 2}, {4, 4}}) {
    const Eigen::MatrixXd part =
        Eigen::MatrixXd::NullaryExpr(kSize, kSize, [&](Eigen::Index, Eigen::Index) { return ++number; });
    blocks.at(index_at<motion::KeyframeIndex>(row), index_at<motion::KeyframeIndex>(column)) += part;
    dense.block(row * kSize, column * kSize, kSize, kSize) += part;
  }
  const Eigen::SparseMatrix<double> matrix = blocks.take();
  EXPECT_EQ(Eigen::MatrixXd(matrix), dense);
  EXPECT_EQ(matrix.nonZeros(), (kKeyframes + 3) * kSize * kSize);
  for (int column = 0; column < matrix.cols(); ++column)
    for (Eigen::SparseMatrix<double>::InnerIterator entry(matrix, column), before(matrix, column); ++entry; ++before)
      EXPECT_GT(entry.row(), before.row()) << "column " << column;
}

TEST(keyframe_blocks, of_keyframes_that_are_not_linked_are_refused) {
  KeyframeBlocks blocks(4, 2, {link(0, 3)});
  const auto at = [&](int row, int column) {
    return blocks.at(index_at<motion::KeyframeIndex>(row), index_at<motion::KeyframeIndex>(column));
  };
  EXPECT_THROW(at(1, 0), Error);
  EXPECT_THROW(at(3, 2), Error);
  EXPECT_THROW(at(0, 3), Error) << "above the diagonal";
  at(3, 0)(1, 1) = 7.0;
  EXPECT_EQ(blocks.take().coeff(7, 1), 7.0);
}

TEST(keyframe_blocks, of_no_keyframes_are_an_empty_matrix) {
  const Eigen::SparseMatrix<double> matrix = KeyframeBlocks(0, 6, {}).take();
  EXPECT_EQ(matrix.nonZeros(), 0);
  Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>, Eigen::Lower> factors(matrix);
  EXPECT_EQ(factors.info(), Eigen::Success);
}

}  // namespace
}  // namespace remount::calibration
