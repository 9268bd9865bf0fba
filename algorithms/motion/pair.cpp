#include "algorithms/motion/pair.h"

#include "messages/pairs.h"

namespace remount::motion {

Message unusable_reason(const Pair& pair) {
  if (!pair.registration.failure.empty()) return pair.registration.failure;
  // Without information it would agree with every X.
  if (pair.registration.attempted && pair.registration.information.isZero(0.0)) return say::pair_determines_nothing();
  if (pair.registration.attempted) return {};
  return pair.state == PairState::Rejected && !pair.reason.empty() && pair.decided_by == DecidedBy::Program
             ? pair.reason
             : say::pair_not_aligned();
}

bool is_cancelled(const RegistrationQuality& quality) {
  return quality.failure.code() == say::registration_cancelled().code();
}

bool is_not_reached(const Pair& pair) { return pair.reason.code() == say::pair_not_reached().code(); }

bool repeats_another(const Pair& pair) { return pair.reason.code() == say::motion_pair_repeats(0).code(); }

}  // namespace remount::motion
