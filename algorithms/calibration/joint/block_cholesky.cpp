#include "algorithms/calibration/joint/block_cholesky.h"

#include <Eigen/Cholesky>
#include <Eigen/OrderingMethods>
#include <Eigen/SparseCore>
#include <algorithm>
#include <cmath>

#include "algorithms/core/index.h"

namespace remount::calibration {
namespace {

// Of the rows, such that few blocks are added by the elimination.
std::vector<std::size_t> elimination_order(const BlockPattern& pattern) {
  const Eigen::Index size = signed_of(pattern.size());
  std::vector<Eigen::Triplet<double>> entries;
  for (std::size_t column = 0; column < pattern.size(); ++column)
    for (const std::size_t row : pattern.rows(column))
      entries.emplace_back(static_cast<int>(row), static_cast<int>(column), 1.0);
  Eigen::SparseMatrix<double> lower(size, size);
  lower.setFromTriplets(entries.begin(), entries.end());
  Eigen::PermutationMatrix<Eigen::Dynamic, Eigen::Dynamic, int> permutation(size);
  if (size > 0) Eigen::AMDOrdering<int>()(lower, permutation);
  std::vector<std::size_t> order;
  for (Eigen::Index i = 0; i < size; ++i) order.push_back(static_cast<std::size_t>(permutation.indices()[i]));
  return order;
}

// Rows of the blocks of L below the diagonal, ascending: those of A, and of each column those of the columns that it
// is the first row of.
std::vector<std::vector<std::size_t>> rows_below(const BlockPattern& pattern, const std::vector<std::size_t>& step) {
  std::vector<std::vector<std::size_t>> below(pattern.size());
  for (std::size_t column = 0; column < pattern.size(); ++column)
    for (const std::size_t row : pattern.rows(column))
      if (row != column) below[std::min(step[row], step[column])].push_back(std::max(step[row], step[column]));
  for (std::vector<std::size_t>& rows : below) {
    std::sort(rows.begin(), rows.end());
    rows.erase(std::unique(rows.begin(), rows.end()), rows.end());
    if (rows.empty()) continue;
    std::vector<std::size_t>& parent = below[rows.front()];
    parent.insert(parent.end(), rows.begin() + 1, rows.end());
  }
  return below;
}

}  // namespace

void BlockCholesky::analyse(const BlockPattern& pattern) {
  order_ = elimination_order(pattern);
  std::vector<std::size_t> step(order_.size());
  for (std::size_t i = 0; i < order_.size(); ++i) step[order_[i]] = i;
  starts_.assign(1, 0);
  rows_.clear();
  for (const std::vector<std::size_t>& rows : rows_below(pattern, step)) {
    rows_.insert(rows_.end(), rows.begin(), rows.end());
    starts_.push_back(rows_.size());
  }
  const auto place = [&](std::size_t row, std::size_t column) {
    const auto start = rows_.begin() + signed_of(starts_[column]), end = rows_.begin() + signed_of(starts_[column + 1]);
    return static_cast<std::size_t>(std::lower_bound(start, end, row) - rows_.begin());
  };
  destinations_.clear();
  for (std::size_t column = 0; column < pattern.size(); ++column)
    for (const std::size_t row : pattern.rows(column)) {
      const bool diagonal = row == column, transposed = step[row] < step[column];
      destinations_.push_back(
          {diagonal ? step[row] : place(std::max(step[row], step[column]), std::min(step[row], step[column])), diagonal,
           transposed});
    }
  updates_.clear();
  for (std::size_t column = 0; column < pattern.size(); ++column)
    for (std::size_t p = starts_[column]; p < starts_[column + 1]; ++p)
      for (std::size_t q = p + 1; q < starts_[column + 1]; ++q)
        updates_.push_back(static_cast<std::uint32_t>(place(rows_[q], rows_[p])));
  analysed_ = pattern;
}

void BlockCholesky::take(const KeyframeBlocks& matrix) {
  diagonal_.resize(order_.size());
  diagonal_inverses_.resize(order_.size());
  below_.assign(rows_.size(), Matrix6d::Zero());
  for (std::size_t i = 0; i < destinations_.size(); ++i) {
    const auto& [place, diagonal, transposed] = destinations_[i];
    const Matrix6d& block = matrix.blocks()[i];
    if (diagonal)
      diagonal_[place] = block;
    else if (transposed)
      below_[place] = block.transpose();
    else
      below_[place] = block;
  }
}

bool BlockCholesky::factorize(const KeyframeBlocks& matrix) {
  if (!analysed_ || *analysed_ != matrix.pattern()) analyse(matrix.pattern());
  take(matrix);
  std::size_t update = 0;
  for (std::size_t column = 0; column < order_.size(); ++column) {
    const Eigen::LLT<Matrix6d> factor(diagonal_[column]);
    if (factor.info() != Eigen::Success) return false;
    Matrix6d& inverse = diagonal_inverses_[column];
    inverse.setIdentity();
    factor.matrixL().solveInPlace(inverse);
    for (std::size_t p = starts_[column]; p < starts_[column + 1]; ++p)
      below_[p] = (below_[p] * inverse.transpose()).eval();
    for (std::size_t p = starts_[column]; p < starts_[column + 1]; ++p) {
      diagonal_[rows_[p]].noalias() -= below_[p] * below_[p].transpose();
      for (std::size_t q = p + 1; q < starts_[column + 1]; ++q)
        below_[updates_[update++]].noalias() -= below_[q] * below_[p].transpose();
    }
  }
  return true;
}

Eigen::MatrixXd BlockCholesky::solve_lower(const Eigen::MatrixXd& sides) const {
  Eigen::MatrixXd halves(sides.cols(), sides.rows());
  for (std::size_t column = 0; column < order_.size(); ++column)
    halves.middleCols<6>(signed_of(6 * column)) = sides.middleRows<6>(signed_of(6 * order_[column])).transpose();
  Eigen::Matrix<double, Eigen::Dynamic, 6> here;
  for (std::size_t column = 0; column < order_.size(); ++column) {
    here = halves.middleCols<6>(signed_of(6 * column)) * diagonal_inverses_[column].transpose();
    halves.middleCols<6>(signed_of(6 * column)) = here;
    for (std::size_t p = starts_[column]; p < starts_[column + 1]; ++p)
      halves.middleCols<6>(signed_of(6 * rows_[p])).noalias() -= here * below_[p].transpose();
  }
  return halves;
}

Eigen::MatrixXd BlockCholesky::solve_upper(Eigen::MatrixXd halves) const {
  Eigen::MatrixXd solutions(halves.cols(), halves.rows());
  Eigen::Matrix<double, Eigen::Dynamic, 6> here;
  for (std::size_t column = order_.size(); column-- > 0;) {
    here = halves.middleCols<6>(signed_of(6 * column));
    for (std::size_t p = starts_[column]; p < starts_[column + 1]; ++p)
      here.noalias() -= halves.middleCols<6>(signed_of(6 * rows_[p])) * below_[p];
    halves.middleCols<6>(signed_of(6 * column)).noalias() = here * diagonal_inverses_[column];
    solutions.middleRows<6>(signed_of(6 * order_[column])) = halves.middleCols<6>(signed_of(6 * column)).transpose();
  }
  return solutions;
}

double BlockCholesky::log_determinant() const {
  double sum = 0.0;
  for (const Matrix6d& inverse : diagonal_inverses_) sum -= 2.0 * inverse.diagonal().array().log().sum();
  return sum;
}

}  // namespace remount::calibration
