// Which column of a table is the time, and what it counts.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "model/guesses/guess.h"
#include "model/guesses/named_columns.h"
#include "model/guesses/time_readings.h"

namespace remount::guesses {

/// How many of the stamps lie within.
std::size_t within(const TimeReading& reading, const std::vector<std::int64_t>& stamps_ns);

/// The likeliest reading, or one within which more of the stamps lie. @param stamps_ns of scans; may be empty
/// @return with what is said of it
struct ChosenTime {
  TimeReading reading;
  Guess guess;
};
std::optional<ChosenTime> choose_time(const SampledTable& table, const ColumnNames& names,
                                      const std::vector<std::int64_t>& stamps_ns);

}  // namespace remount::guesses
