// In which ways columns of a table may be its time: by their names, and by how they go.
#pragma once

#include <string>
#include <vector>

#include "model/formats/files/declared_table.h"
#include "model/guesses/named_columns.h"

namespace remount::guesses {

inline constexpr double kEarliest_s = 3e8;  ///< of times that are dates: 1979

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
  bool order_open = false;     ///< of a date: its numbers may be day and month in either order
  bool counts = false;         ///< whole numbers of one step, which may count the rows
  std::string not_the_unit;    ///< which a title states, and in which rows would follow each other as no log's do
  bool rate_unlikely = false;  ///< no INS is recorded so
  double readable = 0.0;       ///< share of the rows that have a time so

  bool week_open() const { return columns.time_scale == formats::TimeScale::GpsWeek; }
};

/// Those that are possible, the likeliest first; none where no column goes up.
std::vector<TimeReading> time_readings(const SampledTable& table, const ColumnNames& names);

/// Numbers that are no time of any clock are none.
double unix_s_from_gps_s(double gps_s);

/// "48.1 Hz": rows a second, by their number and the time from the first to the last.
double rows_per_second(const SampledTable& table, const TimeReading& reading);

}  // namespace remount::guesses
