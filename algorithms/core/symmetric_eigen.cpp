#include "algorithms/core/symmetric_eigen.h"

namespace remount {

Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> symmetric_eigen(const Eigen::Matrix3d& matrix) {
  return Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(matrix);
}

Eigen::SelfAdjointEigenSolver<Eigen::Matrix<double, 6, 6>> symmetric_eigen(const Eigen::Matrix<double, 6, 6>& matrix) {
  return Eigen::SelfAdjointEigenSolver<Eigen::Matrix<double, 6, 6>>(matrix);
}

Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> symmetric_eigen(const Eigen::MatrixXd& matrix) {
  return Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(matrix);
}

}  // namespace remount
