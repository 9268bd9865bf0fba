// What the numbers of a time column mean: formats do not say.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace remount::formats {

enum class ScalarType { I8, U8, I16, U16, I32, U32, I64, U64, F32, F64 };

/// What is known of a time column besides its values.
struct TimeColumn {
  ScalarType type = ScalarType::F32;
  std::optional<double> unit_s;  ///< where the format states it
};

/// Seconds from the stamp are (value - zero) * unit_s.
struct PointTimeScale {
  double unit_s = 1.0;
  std::optional<double> zero;    ///< in the column's unit; nothing: the scan's earliest point is of the stamp
  double low = 0.0, high = 0.0;  ///< of the column; what lies outside is no time of this scan
  bool another_clock = false;    ///< neither from the stamp on nor on its clock
  bool dates = false;            ///< Unix time, of this century or shortly before it
};

/// The unit (s, ms, us, ns) follows from the sweep: from its size alone only where it is a date near the stamp or of
/// this century, or where the scan has no sweep; otherwise it is the largest with which the sweep takes no more than
/// two seconds. 32-bit unsigned integers are nanoseconds (Ouster `t`, Livox `offset_time`) unless many points within a
/// millisecond say otherwise. Times within one sweep (at least a second) of zero are from the stamp on; those near the
/// stamp on its clock, where a whole number of half hours, up to 14 h, is a time zone (file names are often local
/// time); all others on a clock of their own. Few values far from the rest decide nothing.
/// @param sample values of the column, not empty, finite; not necessarily all
/// @param points how many the scan has @param stamp_ns of the scan, Unix time; 0: not known
PointTimeScale find_time_scale(std::vector<double> sample, std::size_t points, const TimeColumn& column,
                               std::int64_t stamp_ns);

}  // namespace remount::formats
