#include "algorithms/calibration/linear_solutions.h"

#include <Eigen/Cholesky>
#include <Eigen/LU>

namespace remount::calibration {

Vector6d symmetric_solution(const Matrix6d& matrix, const Vector6d& side) { return matrix.ldlt().solve(side); }

Matrix6d symmetric_solution(const Matrix6d& matrix, const Matrix6d& sides) { return matrix.ldlt().solve(sides); }

Eigen::MatrixXd symmetric_solution(const Eigen::MatrixXd& matrix, const Eigen::MatrixXd& sides) {
  return matrix.ldlt().solve(sides);
}

Matrix6d symmetric_inverse(const Matrix6d& matrix) { return matrix.ldlt().solve(Matrix6d::Identity()); }

Matrix6d inverse_by_lu(const Matrix6d& matrix) { return matrix.inverse(); }

}  // namespace remount::calibration
