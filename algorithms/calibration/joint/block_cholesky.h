// Solves sparse positive definite systems of 6x6 blocks: A = L L', with few enough blocks in L.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "algorithms/calibration/joint/keyframe_blocks.h"

namespace remount::calibration {

/// By blocks, for which keyframes have six unknowns each: numbers that are side by side in memory, and a tenth of the
/// places to look up of a factorisation by single numbers.
class BlockCholesky {
 public:
  /// False where A is not positive definite. The order of elimination, which takes longer to find than the factor, is
  /// kept from one matrix to the next as long as they have the same blocks.
  bool factorize(const KeyframeBlocks& matrix);

  /// Of the matrix that was factorised last, like everything below.
  Eigen::MatrixXd solve(const Eigen::MatrixXd& sides) const { return solve_upper(solve_lower(sides)); }

  /// Half of a solution, L^-1 times the sides: transposed, a row a side, with the unknowns in order of elimination.
  /// F of sides B has F F' = B' A^-1 B.
  Eigen::MatrixXd solve_lower(const Eigen::MatrixXd& sides) const;
  /// The other half, from what solve_lower returns, or from sums of its rows: a column a side.
  Eigen::MatrixXd solve_upper(Eigen::MatrixXd halves) const;

  double log_determinant() const;

 private:
  void analyse(const BlockPattern& pattern);
  void take(const KeyframeBlocks& matrix);

  // Where a block of A goes in L, which may be below the diagonal there when it is above it in A.
  struct Destination {
    std::size_t place;
    bool diagonal, transposed;
  };

  std::optional<BlockPattern> analysed_;
  std::vector<std::size_t> order_;           // of elimination: the rows of A
  std::vector<Destination> destinations_;    // of all blocks of A
  std::vector<std::size_t> starts_, rows_;   // of each column of L below the diagonal, and the end; rows by elimination
  std::vector<std::uint32_t> updates_;       // which blocks a column changes, in the order in which it does
  std::vector<Matrix6d> diagonal_, below_;   // of L
  std::vector<Matrix6d> diagonal_inverses_;  // of the blocks on the diagonal of L
};

}  // namespace remount::calibration
