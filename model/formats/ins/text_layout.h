// Tables of post-processing programs: which columns there are, by the names and units in their heads.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "algorithms/core/index.h"

namespace remount::formats {

enum class TextColumn {
  Week,     ///< of GPS
  GpsTime,  ///< seconds of the week or the day, or a time of day
  GpsDate,
  UtcTime,
  UtcDate,
  UtcHours,    ///< where the time of day is three columns, UtcTime being its seconds
  UtcMinutes,  ///< likewise
  Latitude,
  Longitude,
  Height,     ///< above the ellipsoid
  SeaHeight,  ///< above mean sea level
  Undulation,
  Roll,
  Pitch,
  Heading,
  SigmaNorth,
  SigmaEast,
  SigmaUp,
  SigmaRoll,
  SigmaPitch,
  SigmaHeading,
  Quality,
};
inline constexpr std::size_t kTextColumns = 22;

enum class TextUnit {
  None,         ///< not stated: the usual one
  Unknown,      ///< stated, and none of these
  UnknownZone,  ///< begins with "UTC", and what follows is no time zone
  Degrees,
  Radians,
  DegreesMinutesSeconds,
  Metres,
  Seconds,
  Milliseconds,
  TimeOfDay,
  MonthDayYear,
  DayMonthYear,
  YearMonthDay,
};

struct PlacedColumn {
  std::string name;    ///< as the file has it
  std::size_t at = 0;  ///< of its first field in a row
  TextUnit unit = TextUnit::None;
  std::string unit_name;  ///< as the file has it
};

struct TextLayout {
  char separator = ' ';  ///< ' ': any blanks
  std::array<std::optional<PlacedColumn>, kTextColumns> columns;
  std::size_t fields = 0;          ///< of a row
  std::size_t rows_at = 0;         ///< byte behind the head
  std::size_t rows_line = 0;       ///< lines of the head
  std::int64_t zone_ahead_ns = 0;  ///< of times of day before UTC, else of dates
  bool inertial_explorer = false;  ///< NovAtel's program, by its name or by names of its own
  bool names_program = false;      ///< Inertial Explorer or Qinertia

  const std::optional<PlacedColumn>& of(TextColumn column) const { return columns[index_of(column)]; }
  bool has(TextColumn column) const { return of(column).has_value(); }
};

/// Of a text that begins with a head: lines about the project, then the columns' names, with units behind them or in
/// the line below. Nothing where no line names latitude, longitude and two more.
std::optional<TextLayout> find_text_layout(std::string_view text);

/// A row, as TextLayout::separator parts it.
void split_row(std::string_view line, char separator, std::vector<std::string_view>& fields);

}  // namespace remount::formats
