// Solutions and inverses of the matrices that calibrations have most, compiled once: Eigen's templates take a compiler
// one to five seconds in every file that instantiates them.
#pragma once

#include "algorithms/geometry/rotation.h"

namespace remount::calibration {

/// x of matrix x = side, by LDLT; of the symmetric matrix the lower triangle is read.
Vector6d symmetric_solution(const Matrix6d& matrix, const Vector6d& side);
Matrix6d symmetric_solution(const Matrix6d& matrix, const Matrix6d& sides);
Eigen::MatrixXd symmetric_solution(const Eigen::MatrixXd& matrix, const Eigen::MatrixXd& sides);
/// By LDLT, of a symmetric matrix.
Matrix6d symmetric_inverse(const Matrix6d& matrix);
/// By LU, of any matrix.
Matrix6d inverse_by_lu(const Matrix6d& matrix);

}  // namespace remount::calibration
