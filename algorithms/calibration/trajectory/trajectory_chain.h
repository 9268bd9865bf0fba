// The normal equations of one session: poses that are linked to their neighbours, and a border that all may touch.
#pragma once

#include <Eigen/Cholesky>
#include <vector>

#include "algorithms/calibration/trajectory/trajectory_terms.h"

namespace remount::calibration {

/// A right-hand side, or a step: of every pose and of the border.
struct ChainVector {
  explicit ChainVector(std::size_t count = 0) : poses(count, Vector6d::Zero()) {}
  std::vector<Vector6d> poses;
  BorderVector border = BorderVector::Zero();
};

/// Block tridiagonal equations with a border, factored in time and memory that grow with the number of poses alone: a
/// general sparse solver would have to find that order first, and what is left of the border here is the very
/// information of X that a general one would have to be asked for.
class TrajectoryChain {
 public:
  explicit TrajectoryChain(std::size_t poses);

  /// Adds weight * J' J.
  void add(const TrajectoryTerm& term, double weight);
  /// J' v of a term, for a right-hand side.
  static void add_transposed(const TrajectoryTerm& term, const Eigen::Vector3d& v, ChainVector& to);
  /// J d of a step.
  static Eigen::Vector3d apply(const TrajectoryTerm& term, const ChainVector& step);

  /// Eliminates the poses. False where the equations are not positive definite.
  bool factor();
  /// What the poses leave of the border's equations. After factor().
  const BorderMatrix& reduced() const { return border_; }
  /// Eliminates the poses from a right-hand side, whose border is then that of reduced().
  void reduce(ChainVector& side) const;
  /// From a reduced side and the border's step to the step of every pose, in place.
  void substitute(const BorderVector& border_step, ChainVector& side) const;
  /// How each pose follows the border: d pose / d border, once for each pose.
  std::vector<Eigen::Matrix<double, 6, kBorderSize>> sensitivity() const;

 private:
  using Link = Eigen::Matrix<double, 6, kBorderSize>;
  std::vector<Matrix6d> diagonal_, to_next_;  // to_next_[i]: rows of pose i, columns of pose i + 1
  std::vector<Link> to_border_;
  std::vector<Eigen::LLT<Matrix6d>> factors_;
  BorderMatrix border_ = BorderMatrix::Zero();
};

}  // namespace remount::calibration
