// How large errors are, compared with what a covariance says of them. Compiled once: Eigen's templates take a compiler
// some seconds in every file that instantiates them.
#pragma once

#include <Eigen/Core>

namespace remount::testing {

/// The square of an error over its sigma: of chi-square with as many degrees of freedom as the error has numbers.
double squared_over_sigma(const Eigen::Ref<const Eigen::VectorXd>& error,
                          const Eigen::Ref<const Eigen::MatrixXd>& covariance);

}  // namespace remount::testing
