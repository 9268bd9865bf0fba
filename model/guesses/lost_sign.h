// Latitudes or longitudes whose sign has got lost: the way is mirrored then, and no attitude turns with it as it is
// called.
#pragma once

#include <optional>
#include <vector>

#include "model/guesses/motion_hypotheses.h"

namespace remount::guesses {

/// Positions with a sign that is turned, and what the drive says of them beside the attitudes of the same columns.
struct LostSign {
  std::vector<PositionReading> position;  ///< one, to which the hypotheses point
  std::vector<Hypothesis> all;
  std::size_t best = 0;  ///< of these

  const Hypothesis& hypothesis() const { return all[best]; }
  /// Mirrored else, and not only turned round: no heading that counts as it is called goes with the numbers then.
  bool mirrored() const { return position.front().negated[0] != position.front().negated[1]; }
};

/// Nothing where attitudes keep to the direction of travel as they are called, or with no sign turned do.
/// @param best of what the numbers say as they stand
std::optional<LostSign> find_lost_sign(const SampledTable& table, const ColumnNames& names, const TimeReading& time,
                                       const Hypothesis& best, const Progress& progress);

}  // namespace remount::guesses
