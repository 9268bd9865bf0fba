#include "tests/algorithms/support/size_of_error.h"

#include <Eigen/Cholesky>

namespace remount::testing {

double squared_over_sigma(const Eigen::Ref<const Eigen::VectorXd>& error,
                          const Eigen::Ref<const Eigen::MatrixXd>& covariance) {
  return error.dot(covariance.ldlt().solve(error));
}

}  // namespace remount::testing
