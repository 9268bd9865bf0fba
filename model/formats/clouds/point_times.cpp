#include "model/formats/clouds/point_times.h"

#include <algorithm>
#include <cmath>

#include "algorithms/core/stamps.h"

namespace remount::formats {
namespace {

constexpr double kUnits_s[] = {1.0, 1e-3, 1e-6, 1e-9};
constexpr double kLongestSweep_s = 2.0;
constexpr double kUsualSweep_s[] = {0.02, 0.5};
/// Shorter than any sweep: a column or two. Their span says nothing about the unit, and where they lie in the sweep
/// does.
constexpr double kColumn_s = 2e-3, kLeastColumn_s = 1e-6;
constexpr std::size_t kMany = 256;  ///< points: more than columns of most sensors have
/// From 1998 to 2099. Sensors without GNSS often begin at 2000.
constexpr double kDates_s[] = {9e8, 4.1e9};
/// Of times that are dates: beyond it, they are a thousandth of what they seem, since the sensor was switched on.
constexpr double kLongestOfDates_s = 20.0, kLongestNearStamp_s = 1000.0;
constexpr double kNearStamp_s = 60.0;

/// The times of one sweep without what lies far off.
struct Sweep {
  double low = 0.0, high = 0.0;
  double span() const { return high - low; }
  double size() const { return std::max(std::abs(low), std::abs(high)); }
};

/// From the closest half of the different values outwards, as long as the next is not many times as far away as what
/// lies between: a zero that many points have counts once.
Sweep main_sweep(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  values.erase(std::unique(values.begin(), values.end()), values.end());
  const std::size_t half = values.size() / 2;
  std::size_t first = 0;
  for (std::size_t i = 0; i + half < values.size(); ++i)
    if (values[i + half] - values[i] < values[first + half] - values[first]) first = i;
  std::size_t last = first + half;
  const double farthest = values.size() < 8 ? 200.0 : 50.0;
  for (bool grown = true; grown;) {
    const double reach = farthest * (values[last] - values[first]);
    const bool down = first > 0 && values[first] - values[first - 1] <= reach;
    const bool up = last + 1 < values.size() && values[last + 1] - values[last] <= reach;
    first -= down, last += up;
    grown = down || up;
  }
  return {values[first], values[last]};
}

/// The stamp in a unit, in two parts: a nanosecond stamp does not fit a double.
double in_units(std::int64_t stamp_ns, double unit_s) {
  const double scale = 1.0 / unit_s;
  return std::floor(static_cast<double>(stamp_ns / 1'000'000'000)) * scale + seconds(stamp_ns % 1'000'000'000) * scale;
}

bool is_date(double time_s) { return time_s >= kDates_s[0] && time_s <= kDates_s[1]; }

/// How far the zone of these times lies from that of the stamp, where they can be on one clock.
std::optional<double> zone_s(const Sweep& sweep, double unit_s, std::int64_t stamp_ns) {
  if (stamp_ns == 0) return std::nullopt;
  const double apart_s = (sweep.low - in_units(stamp_ns, unit_s)) * unit_s;
  const double zone = is_date(sweep.low * unit_s) ? std::round(apart_s / 1800.0) * 1800.0 : 0.0;
  if (std::abs(zone) > 14.0 * 3600.0 || std::abs(apart_s - zone) >= kNearStamp_s) return std::nullopt;
  return zone;
}

/// The unit in which the times are dates.
std::optional<double> unit_of_dates(const Sweep& sweep, ScalarType type, std::int64_t stamp_ns) {
  for (const double unit_s : kUnits_s) {
    if (!is_date(sweep.low * unit_s)) continue;
    const bool near_stamp = zone_s(sweep, unit_s, stamp_ns).has_value();
    if (near_stamp && sweep.span() * unit_s <= kLongestNearStamp_s) return unit_s;
    if (type != ScalarType::U32 && sweep.span() * unit_s <= kLongestOfDates_s) return unit_s;
  }
  return std::nullopt;
}

/// The largest unit with which so much is within a sweep. Integers do not count seconds.
double unit_of_duration(double duration, ScalarType type) {
  const bool whole = type != ScalarType::F32 && type != ScalarType::F64;
  for (const double unit_s : kUnits_s)
    if (duration * unit_s <= kLongestSweep_s && !(whole && unit_s == 1.0)) return unit_s;
  return 1e-9;
}

double unit_of(const Sweep& sweep, std::size_t points, const TimeColumn& column, std::int64_t stamp_ns) {
  if (column.unit_s) return *column.unit_s;
  if (const auto unit_s = unit_of_dates(sweep, column.type, stamp_ns)) return *unit_s;
  const double of_span_s = unit_of_duration(sweep.span(), column.type);
  const double of_size_s = unit_of_duration(sweep.size(), column.type);
  const double sweep_s = sweep.span() * of_span_s;
  if (column.type == ScalarType::U32) {
    const bool usual = sweep_s >= kUsualSweep_s[0] && sweep_s <= kUsualSweep_s[1];
    return points >= kMany && usual ? of_span_s : 1e-9;
  }
  const double column_s = sweep.span() * of_size_s;
  const bool column_of_sweep = points < kMany && column_s >= kLeastColumn_s && column_s < kColumn_s &&
                               sweep.size() * of_size_s <= kUsualSweep_s[1];
  return sweep_s >= kColumn_s && !column_of_sweep ? of_span_s : of_size_s;
}

}  // namespace

PointTimeScale find_time_scale(std::vector<double> sample, std::size_t points, const TimeColumn& column,
                               std::int64_t stamp_ns) {
  const Sweep sweep = main_sweep(std::move(sample));
  PointTimeScale scale;
  scale.unit_s = unit_of(sweep, points, column, stamp_ns);
  const double around = std::max(kLongestSweep_s / scale.unit_s, sweep.span());
  scale.low = sweep.low - around;
  scale.high = sweep.high + around;
  const double near = std::max(1.0 / scale.unit_s, sweep.span());
  const auto within_a_sweep = [&](double zero) { return sweep.low - zero < near && sweep.high - zero > -near; };
  if (within_a_sweep(0.0)) {
    scale.zero = 0.0;
  } else if (const auto zone = zone_s(sweep, scale.unit_s, stamp_ns)) {
    const double zero = in_units(stamp_ns, scale.unit_s) + *zone / scale.unit_s;
    if (within_a_sweep(zero)) scale.zero = zero;
  }
  scale.another_clock = !scale.zero && stamp_ns != 0;
  scale.dates = is_date(sweep.low * scale.unit_s);
  return scale;
}

}  // namespace remount::formats
