#include "algorithms/calibration/joint/block_cholesky.h"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>
#include <random>

#include "algorithms/core/index.h"

namespace remount::calibration {
namespace {

struct System {
  KeyframeBlocks blocks;
  Eigen::MatrixXd dense;
};

// Sums of squares, as terms make them.
System system_of(std::size_t size, const std::vector<BlockPattern::Link>& links, unsigned seed) {
  std::mt19937 random(seed);
  std::normal_distribution<double> normal;
  const auto part = [&] { return Matrix6d::NullaryExpr([&](Eigen::Index, Eigen::Index) { return normal(random); }); };
  System system{KeyframeBlocks(BlockPattern(size, links)),
                Eigen::MatrixXd::Zero(signed_of(6 * size), signed_of(6 * size))};
  const auto add = [&](std::size_t row, std::size_t column, const Matrix6d& block) {
    system.blocks.at(row, column) += block;
    system.dense.block<6, 6>(signed_of(6 * row), signed_of(6 * column)) += block;
    if (row != column) system.dense.block<6, 6>(signed_of(6 * column), signed_of(6 * row)) += block.transpose();
  };
  for (std::size_t i = 0; i < size; ++i) add(i, i, 0.1 * Matrix6d::Identity());
  for (const auto& [one, other] : links) {
    const Matrix6d of_row = part(), of_column = part();
    const std::size_t row = std::max(one, other), column = std::min(one, other);
    add(row, row, of_row.transpose() * of_row);
    add(column, column, of_column.transpose() * of_column);
    add(row, column, of_row.transpose() * of_column);
  }
  return system;
}

// Neighbours, those behind them, and a road that is driven twice.
std::vector<BlockPattern::Link> links_of_drive(std::size_t size) {
  std::vector<BlockPattern::Link> links;
  for (std::size_t i = 0; i + 1 < size; ++i) links.emplace_back(i, i + 1);
  for (std::size_t i = 0; i + 3 < size; i += 2) links.emplace_back(i + 3, i);
  for (std::size_t i = 0; i < size / 3; ++i) links.emplace_back(i, size - 1 - i);
  return links;
}

TEST(block_cholesky, solves_as_a_dense_factorisation_does) {
  for (const std::size_t size : {1U, 2U, 7U, 40U}) {
    const System system = system_of(size, links_of_drive(size), 11);
    BlockCholesky factors;
    ASSERT_TRUE(factors.factorize(system.blocks));
    const Eigen::LLT<Eigen::MatrixXd> dense(system.dense);
    const Eigen::MatrixXd sides = Eigen::MatrixXd::Random(system.dense.rows(), 5), expected = dense.solve(sides);
    const double error = (factors.solve(sides) - expected).norm() / expected.norm();
    EXPECT_LT(error, 1e-10) << size << " blocks";
    const Eigen::MatrixXd halves = factors.solve_lower(sides), inner = sides.transpose() * expected;
    EXPECT_LT((halves * halves.transpose() - inner).norm(), 1e-10 * inner.norm());
    const double log_determinant = 2.0 * dense.matrixLLT().diagonal().array().log().sum();
    EXPECT_NEAR(factors.log_determinant(), log_determinant, 1e-9 * std::abs(log_determinant));
    RecordProperty("relative error of " + std::to_string(size) + " blocks", std::to_string(error));
  }
}

TEST(block_cholesky, takes_other_numbers_and_other_patterns_after_it) {
  BlockCholesky factors;
  for (const std::size_t size : {12U, 12U, 5U, 20U}) {
    const System system = system_of(size, links_of_drive(size), static_cast<unsigned>(size));
    ASSERT_TRUE(factors.factorize(system.blocks));
    const Eigen::MatrixXd sides = Eigen::MatrixXd::Random(system.dense.rows(), 2);
    EXPECT_LT((system.dense * factors.solve(sides) - sides).norm(), 1e-9 * sides.norm()) << size << " blocks";
  }
}

TEST(block_cholesky, refuses_what_is_not_positive_definite_and_goes_on) {
  System system = system_of(6, links_of_drive(6), 3);
  const System good = system;
  system.blocks.at(3, 3)(2, 2) = -1.0;
  BlockCholesky factors;
  EXPECT_FALSE(factors.factorize(system.blocks));
  EXPECT_TRUE(factors.factorize(good.blocks));
}

TEST(block_cholesky, of_nothing_is_nothing) {
  BlockCholesky factors;
  ASSERT_TRUE(factors.factorize(KeyframeBlocks()));
  EXPECT_EQ(factors.log_determinant(), 0.0);
  EXPECT_EQ(factors.solve(Eigen::MatrixXd(0, 3)).rows(), 0);
}

}  // namespace
}  // namespace remount::calibration
