// Times of rows of a trajectory, by the columns that there are.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "model/formats/files/running_period.h"
#include "model/formats/ins/text_layout.h"

namespace remount::formats {

/// Whether a layout has columns that a time follows from, with the week or without it.
bool has_time(const TextLayout& layout);

/// Takes the rows in their order; before the first, all of them may be counted.
class TextTimes {
 public:
  explicit TextTimes(const TextLayout& layout);

  /// Seconds beside a date are of the week or of the day: whether count() has something to tell.
  bool has_open_seconds() const;
  /// Most rows of a table tell, for one of them may be broken. `fields` has as many as the layout.
  void count(const std::vector<std::string_view>& fields);

  /// UTC; of week 0 where the week is open. Nothing where the fields hold no time. `fields` has as many as the layout.
  std::optional<std::int64_t> stamp_ns(const std::vector<std::string_view>& fields);
  /// Whether the time is a time of day and no column tells the day: there is no stamp then.
  bool lacks_date(const std::vector<std::string_view>& fields) const;
  bool from_gps() const { return plan_ == Plan::GpsWeek || plan_ == Plan::GpsDate || plan_ == Plan::GpsAlone; }
  /// So far, after the first row.
  bool week_open() const { return week_open_; }

 private:
  enum class Plan { GpsWeek, GpsDate, UtcDate, UtcClock, GpsAlone, UtcAlone };

  TextColumn time_column() const { return from_gps() ? TextColumn::GpsTime : TextColumn::UtcTime; }
  bool is_time_of_day(const std::vector<std::string_view>& fields) const;
  std::optional<std::int64_t> time_ns(const std::vector<std::string_view>& fields) const;
  std::optional<std::int64_t> date_ns(const std::vector<std::string_view>& fields) const;
  std::optional<std::int64_t> seconds_of_week_ns(std::int64_t time_ns, std::int64_t midnight_gps_ns) const;
  std::optional<std::int64_t> dated_ns(std::int64_t time_ns, const std::vector<std::string_view>& fields) const;
  std::optional<std::int64_t> clock_ns(const std::vector<std::string_view>& fields) const;

  const TextLayout& layout_;
  Plan plan_ = Plan::GpsAlone;
  RunningPeriod weeks_ = count_weeks();
  bool week_open_ = false;
  std::size_t only_of_week_ = 0, only_of_day_ = 0;  ///< rows whose seconds can be nothing else
};

}  // namespace remount::formats
