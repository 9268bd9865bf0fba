#include "algorithms/calibration/pairwise/noise_prior.h"

#include <algorithm>
#include <cmath>

namespace remount::calibration {

NoisePrior noise_prior(const PairwiseInput& input) {
  NoisePrior prior;
  NoiseModel sum;
  sum.ins_position_sigma_m = sum.ins_attitude_sigma_rad = 0.0;
  bool declared = true;
  for (const SessionNoise& session : input.sessions) {
    const bool here = std::isfinite(session.position_white_sigma_m) && std::isfinite(session.attitude_white_sigma_rad);
    declared = declared && here;
    const SolveOptions& assumed = input.options;
    sum.ins_position_sigma_m += known_or(session.position_white_sigma_m, assumed.ins_position_sigma_m);
    sum.ins_attitude_sigma_rad +=
        std::hypot(known_or(session.attitude_white_sigma_rad, degrees_to_radians(assumed.ins_attitude_sigma_deg)),
                   session.attitude_rounding_rad);
    prior.declared_position_drift += known_or(session.position_drift, 0.0);
    prior.declared_attitude_drift += known_or(session.attitude_drift, 0.0);
    sum.ins_position_drift += known_or(session.position_drift, here ? 0.0 : assumed.ins_position_drift_m);
    sum.ins_attitude_drift +=
        known_or(session.attitude_drift, here ? 0.0 : degrees_to_radians(assumed.ins_attitude_drift_deg));
  }
  const double sessions = std::max<double>(1.0, static_cast<double>(input.sessions.size()));
  // No INS is exact, whatever its log says.
  constexpr double kLeastPosition_m = 1e-4, kLeastAttitude_rad = 1e-6;
  prior.expected.ins_position_sigma_m = std::max(kLeastPosition_m, sum.ins_position_sigma_m / sessions);
  prior.expected.ins_attitude_sigma_rad = std::max(kLeastAttitude_rad, sum.ins_attitude_sigma_rad / sessions);
  prior.declared_position_drift /= sessions;
  prior.declared_attitude_drift /= sessions;
  prior.expected.ins_position_drift = sum.ins_position_drift / sessions;
  prior.expected.ins_attitude_drift = sum.ins_attitude_drift / sessions;
  const double ins_spread = declared ? 0.3 : 1.5;
  const double position_drift_spread = prior.expected.ins_position_drift > 0.0 ? 0.7 : 0.0;
  const double attitude_drift_spread = prior.expected.ins_attitude_drift > 0.0 ? 0.7 : 0.0;
  prior.log_spread = {ins_spread, ins_spread, 1.0, 1.0, 1.0, position_drift_spread, attitude_drift_spread};
  return prior;
}

NoiseModel with_declared_drift(NoiseModel estimated, const NoisePrior& prior) {
  estimated.ins_position_drift = std::max(estimated.ins_position_drift, prior.declared_position_drift);
  estimated.ins_attitude_drift = std::max(estimated.ins_attitude_drift, prior.declared_attitude_drift);
  return estimated;
}

}  // namespace remount::calibration
