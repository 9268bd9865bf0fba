// Eigenvalues and eigenvectors of symmetric matrices, compiled once: Eigen's templates take a compiler ten to thirty
// seconds in every file that instantiates them.
#pragma once

#include <Eigen/Eigenvalues>

namespace remount {

/// Of a symmetric matrix, of which the lower triangle is read: eigenvalues ascending, eigenvectors in columns.
Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> symmetric_eigen(const Eigen::Matrix3d& matrix);
Eigen::SelfAdjointEigenSolver<Eigen::Matrix<double, 6, 6>> symmetric_eigen(const Eigen::Matrix<double, 6, 6>& matrix);
Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> symmetric_eigen(const Eigen::MatrixXd& matrix);

}  // namespace remount
