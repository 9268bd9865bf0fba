// Which columns of a table are position and attitude, and how they count: told by names, by how they change, and by the
// direction of travel.
#pragma once

#include <optional>
#include <vector>

#include "algorithms/core/progress.h"
#include "model/formats/ins/ins_table.h"
#include "model/guesses/guess.h"
#include "model/guesses/sampled_table.h"
#include "model/guesses/time_guess.h"
#include "model/guesses/travel_fit.h"

namespace remount::guesses {

struct ChosenMotion {
  formats::InsTableLayout layout;  ///< but for the time and how rows are parted
  Guess position, attitude;
  std::vector<Guess> others;  ///< errors, quality
  TravelFit fit;
  bool exchanged = false;  ///< latitude and longitude, or x to the east and to the north, against what is usual
};

/// Nothing where there is no position or no attitude, of which `missing` says which, and where it was cancelled.
std::optional<ChosenMotion> choose_motion(const SampledTable& table, const ColumnNames& names, const TimeReading& time,
                                          const Progress& progress, std::vector<Message>& missing);

}  // namespace remount::guesses
