// How long errors of neighbours are alike.
#pragma once

#include <Eigen/Core>
#include <vector>

namespace remount {

/// Variance of the mean of a sequence of errors, over what it would be were they independent: neighbours of a smooth
/// error say little more than one of them. `residuals` are what a fit left of them, evenly sampled; `taken` is how many
/// unknowns it took out of them, which is the slowest part of such an error: it is put back. 1 where chance alone shows
/// as much.
double lasting_factor(const std::vector<double>& residuals, double taken);

/// What the sigma of each unknown of a fit is to be multiplied by where errors last from row to row, 1 or more. Sums of
/// scores over blocks of rows scatter more then than independent ones would. Nobody knows for how long errors last:
/// blocks of several lengths are tried, and what chance shows is not counted.
/// docs/maths/vehicle-frame.md (V11)
/// @param covariance of the unknowns, for independent errors
/// @param fewest_blocks of the longest that are tried: the fewer, the longer may errors last, and the more of what is
/// found is chance
/// @param scores one row of the fit a row, in their order in time: weight times Jacobian transposed times residual
Eigen::VectorXd lasting_widening(const Eigen::MatrixXd& covariance, const Eigen::MatrixXd& scores,
                                 int fewest_blocks = 4);

}  // namespace remount
