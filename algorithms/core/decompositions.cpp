#include "algorithms/core/decompositions.h"

#include <Eigen/QR>
#include <algorithm>

namespace remount {

Eigen::JacobiSVD<Eigen::Matrix3d> singular_values(const Eigen::Matrix3d& matrix) {
  return Eigen::JacobiSVD<Eigen::Matrix3d>(matrix, Eigen::ComputeFullU | Eigen::ComputeFullV);
}

Eigen::JacobiSVD<Eigen::MatrixXd> singular_values(const Eigen::MatrixXd& matrix, unsigned int wanted) {
  return Eigen::JacobiSVD<Eigen::MatrixXd>(matrix, wanted);
}

Eigen::VectorXd least_norm_solution(const Eigen::JacobiSVD<Eigen::MatrixXd>& svd, const Eigen::VectorXd& side) {
  return svd.solve(side);
}

Eigen::MatrixXd orthogonal_factor(const Eigen::MatrixXd& matrix) {
  return Eigen::HouseholderQR<Eigen::MatrixXd>(matrix).householderQ();
}

Eigen::MatrixXd triangular_factor(const Eigen::MatrixXd& matrix) {
  return Eigen::HouseholderQR<Eigen::MatrixXd>(matrix)
      .matrixQR()
      .topRows(std::min(matrix.rows(), matrix.cols()))
      .triangularView<Eigen::Upper>()
      .toDenseMatrix();
}

Eigen::VectorXd least_squares(const Eigen::MatrixXd& matrix, const Eigen::VectorXd& side) {
  return Eigen::HouseholderQR<Eigen::MatrixXd>(matrix).solve(side);
}

Eigen::VectorXd least_norm_solution(const Eigen::MatrixXd& matrix, const Eigen::VectorXd& side) {
  return matrix.completeOrthogonalDecomposition().solve(side);
}

Eigen::MatrixXd pseudo_inverse(const Eigen::MatrixXd& matrix) {
  return matrix.completeOrthogonalDecomposition().pseudoInverse();
}

}  // namespace remount
