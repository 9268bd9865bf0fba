// Singular values and QR of dense matrices, compiled once: Eigen's templates take a compiler ten to twenty seconds in
// every file that instantiates them. Symmetric matrices: symmetric_eigen.h.
#pragma once

#include <Eigen/SVD>

namespace remount {

/// With all of U and V.
Eigen::JacobiSVD<Eigen::Matrix3d> singular_values(const Eigen::Matrix3d& matrix);
/// @param wanted of Eigen::ComputeThinU and Eigen::ComputeThinV
Eigen::JacobiSVD<Eigen::MatrixXd> singular_values(const Eigen::MatrixXd& matrix, unsigned int wanted);
/// The orthogonal factor Q of QR, whole: its first columns span those of `matrix`, the others what they do not.
Eigen::MatrixXd orthogonal_factor(const Eigen::MatrixXd& matrix);
/// The upper triangle R of QR, as many rows as columns where `matrix` has no fewer.
Eigen::MatrixXd triangular_factor(const Eigen::MatrixXd& matrix);
/// x that minimises |matrix x - side|, of full column rank.
Eigen::VectorXd least_squares(const Eigen::MatrixXd& matrix, const Eigen::VectorXd& side);
/// The shortest x that minimises |matrix x - side|, of any rank; of one whose singular values are known already, with U
/// and V, those below the threshold set there being none.
Eigen::VectorXd least_norm_solution(const Eigen::MatrixXd& matrix, const Eigen::VectorXd& side);
Eigen::VectorXd least_norm_solution(const Eigen::JacobiSVD<Eigen::MatrixXd>& svd, const Eigen::VectorXd& side);
Eigen::MatrixXd pseudo_inverse(const Eigen::MatrixXd& matrix);

}  // namespace remount
