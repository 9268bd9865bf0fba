// What columns of tables are called, by makers and by people: one list for all.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace remount::guesses {

enum class Quantity {
  Time,         ///< of whatever clock
  HostTime,     ///< when somebody wrote the line
  GpsTime,      ///< of GPS: since 1980, or of the week
  WeekSeconds,  ///< of the week
  Week,
  Date,  ///< a day, or a day with its time
  Seconds,
  Nanoseconds,  ///< beside whole seconds
  Microseconds,
  Milliseconds,
  Year,
  Month,
  MonthDay,
  Hour,
  Minute,
  Latitude,
  Longitude,
  Height,
  SeaHeight,
  East,
  North,
  Up,
  Down,
  X,
  Y,
  Z,
  Roll,
  Pitch,
  Heading,  ///< from north, clockwise, as it is usually meant
  Yaw,      ///< either
  Qx,
  Qy,
  Qz,
  Qw,
  SigmaEast,
  SigmaNorth,
  SigmaUp,
  SigmaRoll,
  SigmaPitch,
  SigmaHeading,
  Quality,
  Scan,    ///< a file of a scan
  Course,  ///< direction of travel: no attitude
  Other,   ///< velocities, rates, counters: known, and of no use here
};

struct NamedQuantity {
  Quantity quantity = Quantity::Other;
  std::string unit;  ///< "deg", "rad", "m", "s", "ms", "us", "ns"; another as it stands there; empty where none does
};

/// Of a title as it stands above a column: "Lat (deg)", "pitch_rad", "纬度(度)", "field.pose.pose.position.x".
/// @param unit_below of a line of units; empty where there is none
std::optional<NamedQuantity> quantity_of(std::string_view title, std::string_view unit_below = {});

/// The unit that a title states, likewise, also one whose name nobody knows: "rad" of "angle3 [rad]".
std::string unit_stated(std::string_view title, std::string_view unit_below = {});

/// "(deg)", "秒": a unit and nothing else.
bool is_unit(std::string_view text);

/// Units in which a manifest can say that this is; empty where any or none will do.
std::vector<std::string_view> units_read(Quantity quantity);
/// False where the title states another unit, or one that is not known: its numbers mean something else then.
bool unit_is_read(const NamedQuantity& column);

}  // namespace remount::guesses
