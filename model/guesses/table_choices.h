// What somebody says of the columns of a table: what each is, and how it counts.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "model/formats/ins/ins_table.h"
#include "model/guesses/sampled_table.h"
#include "model/guesses/time_guess.h"

namespace remount::guesses {

/// What a manifest can say that a column is.
enum class ColumnRole {
  Ignored,
  Time,
  Day,          ///< of a time of day, or of the month beside year, month, hour and minute
  Week,         ///< of GPS
  Nanoseconds,  ///< beside whole seconds
  Microseconds,
  Milliseconds,
  Year,
  Month,
  Hour,
  Minute,
  Latitude,
  Longitude,
  LatitudeSide,   ///< N or S
  LongitudeSide,  ///< E or W
  East,
  North,
  Height,  ///< or up, beside east and north
  Down,
  Yaw,  ///< or heading
  Pitch,
  Roll,
  Qx,
  Qy,
  Qz,
  Qw,
  SigmaEast,
  SigmaNorth,
  SigmaUp,
  SigmaYaw,
  SigmaPitch,
  SigmaRoll,
  Quality,
};
inline constexpr std::size_t kColumnRoleCount = 33;
/// "latitude".
Message words(ColumnRole role);

// What says one thing together, in the order of the roles.
inline constexpr std::array kTimeRoles{
    ColumnRole::Time,         ColumnRole::Day,  ColumnRole::Week,  ColumnRole::Nanoseconds, ColumnRole::Microseconds,
    ColumnRole::Milliseconds, ColumnRole::Year, ColumnRole::Month, ColumnRole::Hour,        ColumnRole::Minute};
/// Parts of a date, beside the day.
inline constexpr std::array kCalendarRoles{ColumnRole::Year, ColumnRole::Month, ColumnRole::Hour, ColumnRole::Minute};
/// Beside whole seconds: one of them.
inline constexpr std::array kRestRoles{ColumnRole::Nanoseconds, ColumnRole::Microseconds, ColumnRole::Milliseconds};
inline constexpr std::array kGeodeticRoles{ColumnRole::Latitude, ColumnRole::Longitude};
/// Letters beside numbers without a sign.
inline constexpr std::array kSideRoles{ColumnRole::LatitudeSide, ColumnRole::LongitudeSide};
inline constexpr std::array kMetricRoles{ColumnRole::East, ColumnRole::North, ColumnRole::Down};
inline constexpr std::array kPositionRoles{ColumnRole::Latitude,      ColumnRole::Longitude, ColumnRole::LatitudeSide,
                                           ColumnRole::LongitudeSide, ColumnRole::East,      ColumnRole::North,
                                           ColumnRole::Height,        ColumnRole::Down};
inline constexpr std::array kAngleRoles{ColumnRole::Yaw, ColumnRole::Pitch, ColumnRole::Roll};
inline constexpr std::array kQuaternionRoles{ColumnRole::Qx, ColumnRole::Qy, ColumnRole::Qz, ColumnRole::Qw};
inline constexpr std::array kAttitudeRoles{ColumnRole::Yaw, ColumnRole::Pitch, ColumnRole::Roll, ColumnRole::Qx,
                                           ColumnRole::Qy,  ColumnRole::Qz,    ColumnRole::Qw};
inline constexpr std::array kPositionSigmaRoles{ColumnRole::SigmaEast, ColumnRole::SigmaNorth, ColumnRole::SigmaUp};
inline constexpr std::array kAttitudeSigmaRoles{ColumnRole::SigmaYaw, ColumnRole::SigmaPitch, ColumnRole::SigmaRoll};
inline constexpr std::array kQualityRoles{ColumnRole::Quality};

template <std::size_t N>
bool is_one_of(ColumnRole role, const std::array<ColumnRole, N>& roles) {
  return std::ranges::find(roles, role) != roles.end();
}

/// How an attitude counts, in the order in which forms offer it.
enum class AttitudeStyle { Heading, EnuYaw, NovAtel, QuaternionEnu, QuaternionNed };
inline constexpr std::size_t kAttitudeStyleCount = 5;
bool is_quaternion(AttitudeStyle style);

struct TableChoices {
  std::vector<ColumnRole> roles;                                  ///< of each column; each role but Ignored once
  std::int64_t time_unit_ns = 1'000'000'000;                      ///< 0: the time is a text with a date
  formats::DateOrder date_order = formats::DateOrder::YearFirst;  ///< of that text
  formats::TimeScale time_scale = formats::TimeScale::Unix;
  std::int64_t offset_ns = 0;                                      ///< added to the times
  formats::PlaceUnit position_unit = formats::PlaceUnit::Degrees;  ///< of latitude and longitude
  std::array<bool, 2> place_negated{};                             ///< latitude, longitude
  AttitudeStyle attitude = AttitudeStyle::Heading;
  bool attitude_in_deg = true;
  std::array<bool, 3> negated{};  ///< yaw, pitch, roll

  std::optional<std::size_t> column(ColumnRole role) const;
  bool has(ColumnRole role) const { return column(role).has_value(); }
  bool metric() const;  ///< east and north in the place of latitude and longitude
  bool operator==(const TableChoices&) const = default;
};

template <std::size_t N>
bool same_columns(const TableChoices& a, const TableChoices& b, const std::array<ColumnRole, N>& roles) {
  return std::ranges::all_of(roles, [&](ColumnRole role) { return a.column(role) == b.column(role); });
}
// Whether two say the same of it: columns and what counts for them.
bool same_time(const TableChoices& a, const TableChoices& b);
bool same_position(const TableChoices& a, const TableChoices& b);
bool same_attitude(const TableChoices& a, const TableChoices& b);

/// Gives a column a role. The column that had it takes the one that this column had; those of another way to say the
/// same (latitude beside east, angles beside a quaternion) are ignored then, and the conventions follow, as does the
/// unit where the title states one.
void give_role(const SampledTable& table, TableChoices& choices, std::size_t column, ColumnRole role);

TableChoices choices_of(const SampledTable& table, const formats::InsTableLayout& layout);
/// Only what is said of the time, only what is said of position and attitude: of an alternative.
void take_time(const SampledTable& table, const formats::TimeColumns& time, TableChoices& choices);
void take_motion(const SampledTable& table, const formats::InsTableLayout& layout, TableChoices& choices);

/// What names say, where no motion was found in a table. @param time as far as one was found
TableChoices choices_by_names(const SampledTable& table, const std::optional<TimeReading>& time);

/// As a manifest has it; nothing where columns are lacking or contradict each other, of which `lacks` then says what.
std::optional<formats::InsTableLayout> layout_of(const SampledTable& table, const TableChoices& choices,
                                                 std::vector<Message>& lacks);

}  // namespace remount::guesses
