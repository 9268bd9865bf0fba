// How long errors of neighbours are alike.
#pragma once

#include <vector>

namespace remount {

/// Variance of the mean of a sequence of errors, over what it would be were they independent: neighbours of a smooth
/// error say little more than one of them. `residuals` are what a fit left of them, evenly sampled; `taken` is how many
/// unknowns it took out of them, which is the slowest part of such an error: it is put back. 1 where chance alone shows
/// as much.
double lasting_factor(const std::vector<double>& residuals, double taken);

}  // namespace remount
