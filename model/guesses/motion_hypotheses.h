// Ways in which position and attitude may be meant together, and what the direction of travel says of each.
#pragma once

#include <vector>

#include "algorithms/core/progress.h"
#include "model/guesses/attitude_readings.h"
#include "model/guesses/travel_fit.h"

namespace remount::guesses {

/// A way in which position and attitude may be meant, with what the drive says of it.
struct Hypothesis {
  const PositionReading* position = nullptr;
  AttitudeReading attitude;
  TravelFit fit;
  double score_rad = 0.0;  ///< the smaller the better
};

/// As boxes are built in: in line with the vehicle, or across it.
bool is_set_square(const TravelFit& fit);

/// Of the offset, either way.
double size_of_offset(const TravelFit& fit);

/// Whether the drive tells anything of a heading.
bool moves(const Hypothesis& hypothesis);

/// Whether two read the same columns, and differ in how they count.
bool same_columns(const AttitudeReading& a, const AttitudeReading& b);

/// All of them; where there are thousands, as of many columns without names, those that fit some stretches best.
/// @param positions which must outlive what is returned
std::vector<Hypothesis> hypotheses_of(const SampledTable& table, const ColumnNames& names, const TimeReading& time,
                                      const std::vector<PositionReading>& positions, const Progress& progress);

/// Puts a pitch that counts the other way in the place of each that the road refutes, of those of the best's columns.
void settle_pitches(const SampledTable& table, const TimeReading& time, const Hypothesis& best,
                    std::vector<Hypothesis>& all);

}  // namespace remount::guesses
