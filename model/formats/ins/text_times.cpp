#include "model/formats/ins/text_times.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdlib>

#include "model/formats/files/input_file.h"
#include "model/formats/files/time_stamp.h"

namespace remount::formats {
namespace {

constexpr std::int64_t kTextSecond_ns = 1'000'000'000, kTextMinute_ns = 60 * kTextSecond_ns,
                       kTextHour_ns = 60 * kTextMinute_ns, kTextDay_ns = 24 * kTextHour_ns;
constexpr std::int64_t kGpsEpochUnix_ns = std::int64_t{315'964'800} * kTextSecond_ns;
/// No seconds of a week, and no date before 1983: such times count from an epoch.
constexpr std::int64_t kLeastSinceEpoch_ns = std::int64_t{100'000'000} * kTextSecond_ns;

/// Of 2096, far from where sums leave 64 bits.
constexpr std::int64_t kLatestTextTime_ns = 4'000'000'000'000'000'000;

/// Parts between any of the separators.
std::vector<std::string_view> parts_of(std::string_view text, std::string_view separators) {
  std::vector<std::string_view> parts;
  for (std::size_t at = 0; at <= text.size();) {
    const std::size_t end = std::min(text.find_first_of(separators, at), text.size());
    parts.push_back(text.substr(at, end - at));
    at = end + 1;
  }
  return parts;
}

/// "14:22:33.25", since midnight.
std::optional<std::int64_t> time_of_day_ns(std::string_view text) {
  const std::vector<std::string_view> parts = parts_of(trim(text), ":");
  if (parts.size() != 3) return std::nullopt;
  const auto hours = parse_integer(parts[0]), minutes = parse_integer(parts[1]);
  const auto seconds_ns = parse_seconds_ns(parts[2]);
  if (!hours || !minutes || !seconds_ns || *hours < 0 || *hours > 23 || *minutes < 0 || *minutes > 59 ||
      *seconds_ns < 0 || *seconds_ns > kTextMinute_ns)
    return std::nullopt;
  return *hours * kTextHour_ns + *minutes * kTextMinute_ns + *seconds_ns;
}

/// Midnight since 1970 of "12/31/2023" and the like; without a unit "2023-12-31" and "31/12/2023".
std::optional<std::int64_t> midnight_ns(std::string_view text, TextUnit unit) {
  const std::vector<std::string_view> parts = parts_of(trim(text), "/-.");
  if (parts.size() != 3) return std::nullopt;
  std::array<std::int64_t, 3> values{};
  for (std::size_t i = 0; i < 3; ++i) {
    const auto value = parse_integer(parts[i]);
    if (!value || *value < 0 || *value > 9999) return std::nullopt;
    values[i] = *value;
  }
  std::array<std::size_t, 3> year_month_day{2, 1, 0};
  if (unit == TextUnit::MonthDayYear) year_month_day = {2, 0, 1};
  if (unit == TextUnit::YearMonthDay || (unit == TextUnit::None && parts[0].size() == 4)) year_month_day = {0, 1, 2};
  std::int64_t year = values[year_month_day[0]];
  if (year < 100) year += 2000;
  using namespace std::chrono;
  const std::chrono::year_month_day date{std::chrono::year(static_cast<int>(year)),
                                         month(static_cast<unsigned>(values[year_month_day[1]])),
                                         day(static_cast<unsigned>(values[year_month_day[2]]))};
  if (!date.ok() || year < 1980 || year > 2100) return std::nullopt;
  return sys_days(date).time_since_epoch().count() * kTextDay_ns;
}

bool has_date_column(const TextLayout& layout) {
  return layout.has(TextColumn::GpsDate) || layout.has(TextColumn::UtcDate);
}

}  // namespace

bool has_time(const TextLayout& layout) { return layout.has(TextColumn::GpsTime) || layout.has(TextColumn::UtcTime); }

TextTimes::TextTimes(const TextLayout& layout) : layout_(layout) {
  const bool gps = layout.has(TextColumn::GpsTime), utc = layout.has(TextColumn::UtcTime),
             date = has_date_column(layout);
  if (gps && layout.has(TextColumn::Week))
    plan_ = Plan::GpsWeek;
  else if (gps && date)
    plan_ = Plan::GpsDate;
  else if (utc && date && layout.has(TextColumn::UtcHours) && layout.has(TextColumn::UtcMinutes))
    plan_ = Plan::UtcClock;
  else if (utc && date)
    plan_ = Plan::UtcDate;
  else
    plan_ = gps ? Plan::GpsAlone : Plan::UtcAlone;
}

bool TextTimes::is_time_of_day(const std::vector<std::string_view>& fields) const {
  const PlacedColumn& placed = *layout_.of(time_column());
  return placed.unit == TextUnit::TimeOfDay || fields[placed.at].find(':') != std::string_view::npos;
}

bool TextTimes::lacks_date(const std::vector<std::string_view>& fields) const {
  return !has_date_column(layout_) && is_time_of_day(fields) && time_ns(fields).has_value();
}

std::optional<std::int64_t> TextTimes::time_ns(const std::vector<std::string_view>& fields) const {
  const PlacedColumn& placed = *layout_.of(time_column());
  const std::string_view text = fields[placed.at];
  if (is_time_of_day(fields)) return time_of_day_ns(text);
  return parse_time_ns(text, placed.unit == TextUnit::Milliseconds ? 1'000'000 : kTextSecond_ns);
}

std::optional<std::int64_t> TextTimes::date_ns(const std::vector<std::string_view>& fields) const {
  const bool utc = plan_ == Plan::UtcDate || plan_ == Plan::UtcClock;
  const auto &first = layout_.of(utc ? TextColumn::UtcDate : TextColumn::GpsDate),
             &second = layout_.of(utc ? TextColumn::GpsDate : TextColumn::UtcDate);
  const PlacedColumn& placed = first ? *first : *second;
  return midnight_ns(fields[placed.at], placed.unit);
}

bool TextTimes::has_open_seconds() const { return plan_ == Plan::GpsDate || plan_ == Plan::UtcDate; }

void TextTimes::count(const std::vector<std::string_view>& fields) {
  const auto time = is_time_of_day(fields) ? std::nullopt : time_ns(fields);
  const auto date = date_ns(fields);
  if (!time || !date || *time < 0 || *time > kLatestInWeek_ns) return;
  const bool of_week = seconds_of_week_ns(*time, *date - kGpsEpochUnix_ns).has_value(), of_day = *time <= kTextDay_ns;
  if (of_week && !of_day) ++only_of_week_;
  if (of_day && !of_week) ++only_of_day_;
}

// Of the week that the day is in, where that meets the day to within what is between the time scales.
std::optional<std::int64_t> TextTimes::seconds_of_week_ns(std::int64_t time_ns, std::int64_t midnight_gps_ns) const {
  const std::int64_t noon_gps_ns = midnight_gps_ns + kTextDay_ns / 2, in_week_ns = time_ns % kGpsWeek_ns;
  const auto weeks = static_cast<std::int64_t>(
      std::llround(static_cast<double>(noon_gps_ns - in_week_ns) / static_cast<double>(kGpsWeek_ns)));
  const std::int64_t by_week_ns = weeks * kGpsWeek_ns + in_week_ns;
  const bool meets = std::abs(by_week_ns - noon_gps_ns) <= kTextDay_ns / 2 + kTextMinute_ns;
  return meets ? std::optional(by_week_ns) : std::nullopt;
}

// A time of day is of the day itself. Seconds are of the week or of the day as most rows have them: on a Sunday both
// are the same.
std::optional<std::int64_t> TextTimes::dated_ns(std::int64_t time_ns,
                                                const std::vector<std::string_view>& fields) const {
  const auto date = date_ns(fields);
  if (!date || time_ns < 0 || time_ns > kLatestInWeek_ns) return std::nullopt;
  const std::int64_t midnight_gps_ns = *date - kGpsEpochUnix_ns;
  if (is_time_of_day(fields)) return midnight_gps_ns + time_ns;
  const auto by_week_ns = seconds_of_week_ns(time_ns, midnight_gps_ns);
  if (only_of_day_ <= only_of_week_) return by_week_ns;
  return time_ns <= kTextDay_ns ? std::optional(midnight_gps_ns + time_ns) : std::nullopt;
}

// UTC of hours, minutes and seconds in three columns.
std::optional<std::int64_t> TextTimes::clock_ns(const std::vector<std::string_view>& fields) const {
  const auto date = date_ns(fields);
  const auto hours = parse_integer(fields[layout_.of(TextColumn::UtcHours)->at]),
             minutes = parse_integer(fields[layout_.of(TextColumn::UtcMinutes)->at]);
  const auto seconds_ns = parse_seconds_ns(fields[layout_.of(TextColumn::UtcTime)->at]);
  if (!date || !hours || !minutes || !seconds_ns || *hours < 0 || *hours > 23 || *minutes < 0 || *minutes > 59 ||
      *seconds_ns < 0 || *seconds_ns > kTextMinute_ns)
    return std::nullopt;
  return *date + *hours * kTextHour_ns + *minutes * kTextMinute_ns + *seconds_ns - layout_.zone_ahead_ns;
}

std::optional<std::int64_t> TextTimes::stamp_ns(const std::vector<std::string_view>& fields) {
  if (plan_ == Plan::UtcClock) return clock_ns(fields);
  const auto time = time_ns(fields);
  if (!time || *time < 0 || *time > kLatestTextTime_ns || lacks_date(fields)) return std::nullopt;
  // Of a week a time of day tells no day, and a date does.
  switch (plan_ == Plan::GpsWeek && is_time_of_day(fields) ? Plan::GpsDate : plan_) {
    case Plan::GpsWeek: {
      const auto week = parse_number(fields[layout_.of(TextColumn::Week)->at]);
      if (!week || !(*week >= 0.0 && *week <= 9999.0)) return std::nullopt;
      return unix_ns_from_gps_week(std::llround(*week), *time);
    }
    case Plan::GpsDate: {
      const auto gps_ns = dated_ns(*time, fields);
      return gps_ns ? std::optional(unix_ns_from_gps_ns(*gps_ns)) : std::nullopt;
    }
    case Plan::UtcDate: {
      const auto utc_ns = dated_ns(*time, fields);
      return utc_ns ? std::optional(*utc_ns + kGpsEpochUnix_ns - layout_.zone_ahead_ns) : std::nullopt;
    }
    case Plan::UtcAlone:
      return *time >= kLeastSinceEpoch_ns ? time : std::nullopt;
    default: {
      if (*time >= kLeastSinceEpoch_ns) return unix_ns_from_gps_ns(*time);
      if (*time > kLatestInWeek_ns) return std::nullopt;
      week_open_ = true;
      const auto running_ns = weeks_.running_ns(*time);
      return running_ns ? std::optional(unix_ns_from_gps_ns(*running_ns)) : std::nullopt;
    }
  }
}

}  // namespace remount::formats
