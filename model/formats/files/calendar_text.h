// Dates as tables write them: in whatever order, with zones, halves of a day and fractions.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

namespace remount::formats {

/// What stands first in a date.
enum class DateOrder {
  YearFirst,
  DayFirst,    ///< 14.11.2023, 14/11/2023
  MonthFirst,  ///< 11/14/2023
};

/// "2023-11-14 22:13:20.5", "2023-11-14T22:13:20.5Z", "2023-11-15T06:13:20+08:00", "11/14/2023 10:13:20 PM",
/// "2023-11-14 22:13:20:500": nanoseconds of a calendar since 1970, without leap seconds, of UTC where a zone is
/// stated. Digits behind nanoseconds are left out. Nothing where the text is no date of that order. Where the year
/// comes last it has four digits, and what parts it is a point, a slash or a dash; it has two where nothing else can be
/// meant: behind points (14.11.23), or behind a number above 12 and slashes (11/14/23).
std::optional<std::int64_t> parse_calendar_ns(std::string_view text, DateOrder order = DateOrder::YearFirst);

}  // namespace remount::formats
