// What is expected of the noise before the residuals are looked at.
#pragma once

#include <array>

#include "algorithms/calibration/pairwise/pairwise.h"

namespace remount::calibration {

struct NoisePrior {
  NoiseModel expected;
  std::array<double, 7> log_spread{};  ///< 1-sigma of the logarithm of each component, as in estimate_noise
  /// Drifts that the logs declare; 0 where they do not.
  double declared_position_drift = 0.0, declared_attitude_drift = 0.0;
};

/// Residuals of neighbouring scans show the drift of a fraction of a second, in which samples are smoothed too, but X
/// suffers from that of the whole drive: what a log declares for it is not refuted by less.
NoiseModel with_declared_drift(NoiseModel estimated, const NoisePrior& prior);

/// Declared sigmas are believed within some 30%, assumed ones within a factor of three to five. Data that declare their
/// white noise and no drift have none.
NoisePrior noise_prior(const PairwiseInput& input);

/// @param value as a log states it, NaN where it does not
inline double known_or(double value, double otherwise) { return std::isfinite(value) ? value : otherwise; }

}  // namespace remount::calibration
