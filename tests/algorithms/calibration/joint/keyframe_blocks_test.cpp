#include "algorithms/calibration/joint/keyframe_blocks.h"

#include <gtest/gtest.h>

#include <vector>

#include "algorithms/core/error.h"

namespace remount::calibration {
namespace {

TEST(keyframe_blocks, lie_where_a_dense_matrix_has_them) {
  constexpr std::size_t kSize = 5;
  // As terms name them: twice, and the later keyframe first or last.
  KeyframeBlocks blocks(BlockPattern(kSize, {{0, 3}, {3, 0}, {4, 1}, {0, 1}, {2, 2}}));
  Eigen::MatrixXd dense = Eigen::MatrixXd::Zero(6 * kSize, 6 * kSize), told = dense;
  int number = 0;
  for (const auto& [row, column] : std::vector<std::pair<int, int>>{{3, 0}, {1, 0}, {3, 0}, {4, 1}, {0, 0}, {4, 4}}) {
    const Matrix6d part = Matrix6d::NullaryExpr([&](Eigen::Index, Eigen::Index) { return ++number; });
    blocks.at(static_cast<std::size_t>(row), static_cast<std::size_t>(column)) += part;
    dense.block<6, 6>(6 * row, 6 * column) += part;
  }
  const BlockPattern& pattern = blocks.pattern();
  EXPECT_EQ(pattern.size(), kSize);
  EXPECT_EQ(pattern.count(), kSize + 3);
  for (std::size_t column = 0; column < pattern.size(); ++column)
    for (std::size_t i = 0; i < pattern.rows(column).size(); ++i) {
      const std::size_t row = pattern.rows(column)[i];
      EXPECT_EQ(pattern.place(row, column), pattern.start(column) + i);
      EXPECT_TRUE(i == 0 ? row == column : row > pattern.rows(column)[i - 1]) << "column " << column;
      told.block<6, 6>(signed_of(6 * row), signed_of(6 * column)) = blocks.blocks()[pattern.start(column) + i];
    }
  EXPECT_EQ(told, dense);
}

TEST(keyframe_blocks, of_keyframes_that_are_not_linked_are_refused) {
  KeyframeBlocks blocks(BlockPattern(4, {{0, 3}}));
  EXPECT_THROW(blocks.at(1, 0), Error);
  EXPECT_THROW(blocks.at(3, 2), Error);
  EXPECT_THROW(blocks.at(0, 3), Error) << "above the diagonal";
  blocks.at(3, 0)(1, 1) = 7.0;
  EXPECT_EQ(blocks.at(3, 0)(1, 1), 7.0);
}

TEST(keyframe_blocks, of_no_keyframes_are_none) {
  EXPECT_EQ(KeyframeBlocks().pattern().size(), 0U);
  EXPECT_EQ(KeyframeBlocks().pattern().count(), 0U);
}

}  // namespace
}  // namespace remount::calibration
