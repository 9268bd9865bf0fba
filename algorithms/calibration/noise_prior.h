// What is expected of the noise before the residuals are looked at.
#pragma once

#include <array>

#include "algorithms/calibration/pairwise.h"

namespace remount {

struct NoisePrior {
  NoiseModel expected;
  std::array<double, 7> log_spread{};  ///< 1-sigma of the logarithm of each component, as in estimate_noise
};

/// Declared sigmas are believed within some 30%, assumed ones within a factor of three to five. Data that declare their
/// white noise and no drift have none.
NoisePrior noise_prior(const PairwiseInput& input);

/// @param value as a log states it, NaN where it does not
inline double known_or(double value, double otherwise) { return std::isfinite(value) ? value : otherwise; }

}  // namespace remount
