// Which column of a table is the time, and what it counts.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "model/guesses/guess.h"
#include "model/guesses/named_columns.h"

namespace remount::guesses {

/// One way in which times may be meant.
struct TimeReading {
  formats::TimeColumns columns;
  std::vector<std::size_t> at;  ///< the columns
  std::string unit;             ///< as a manifest has it: "s", "date"
  std::vector<double> times_s;  ///< of the sampled rows, since 1970, UTC; NaN where there is none
  double first_s = 0.0, last_s = 0.0;
  double weight = 0.0;  ///< by names and by how it goes; the largest first
  bool by_name = false;
  bool unit_by_name = false;
  bool order_open = false;  ///< of a date: its numbers may be day and month in either order

  bool week_open() const { return columns.time_scale == formats::TimeScale::GpsWeek; }
};

/// Those that are possible, the likeliest first; none where no column goes up.
std::vector<TimeReading> time_readings(const SampledTable& table, const ColumnNames& names);

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

/// "48.1 Hz": rows a second, by their number and the time from the first to the last.
double rows_per_second(const SampledTable& table, const TimeReading& reading);

}  // namespace remount::guesses
