#include "algorithms/trajectory/pair.h"

namespace remount {

Message unusable_reason(const Pair& pair) {
  if (!pair.registration.failure.empty()) return pair.registration.failure;
  // Without information it would agree with every X.
  if (pair.registration.attempted && pair.registration.information.isZero(0.0)) return "its scans determine nothing";
  if (pair.registration.attempted) return {};
  return pair.state == PairState::Rejected && !pair.reason.empty() && pair.decided_by == DecidedBy::Program
             ? pair.reason
             : "its scans were not aligned";
}

}  // namespace remount
