// What the terms of the joint problem add to the block of the unknowns that all of them share.
#pragma once

#include <Eigen/Core>

namespace remount::calibration {

/// Where that block is wide (errors of beams) many terms are multiplied at once, in parts that fit a cache; few columns
/// are multiplied faster one by one, without preparing them for it.
class SharedBlock {
 public:
  using Jacobian = Eigen::Matrix<double, 6, Eigen::Dynamic>;

  /// Adds to what `sum` holds, which outlives this.
  explicit SharedBlock(Eigen::MatrixXd& sum);

  /// @param weighted the jacobian times the term's information
  void add(const Jacobian& jacobian, const Jacobian& weighted);
  /// Before the sum is read.
  void finish();

 private:
  void add_rows();

  Eigen::MatrixXd& sum_;
  Eigen::MatrixXd plain_, weighted_;  // of some terms, below each other; without rows where the block is narrow
  Eigen::Index rows_ = 0;
};

}  // namespace remount::calibration
