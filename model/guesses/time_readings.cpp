#include "model/guesses/time_readings.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <initializer_list>
#include <limits>
#include <optional>
#include <tuple>
#include <utility>

#include "model/formats/files/time_stamp.h"
#include "model/formats/files/time_unit.h"
#include "model/formats/poses/pose_columns.h"
#include "model/guesses/time_steps.h"

namespace remount::guesses {
namespace {

using formats::DateOrder;
using formats::TimeColumns;
using formats::TimeScale;

constexpr double kDay_s = 86'400.0, kLatest_s = 4.1e9;  // 2099
constexpr double kGpsEpoch_s = 1e-9 * static_cast<double>(formats::kGpsEpoch_ns);
constexpr double kNotATime = std::numeric_limits<double>::quiet_NaN();

constexpr std::pair<Quantity, std::int64_t> kRests[] = {
    {Quantity::Nanoseconds, 1}, {Quantity::Microseconds, 1'000}, {Quantity::Milliseconds, 1'000'000}};

std::optional<std::int64_t> rest_unit_ns(std::optional<Quantity> quantity) {
  for (const auto& [rest, unit_ns] : kRests)
    if (quantity == rest) return unit_ns;
  return std::nullopt;
}

class TimeReader {
 public:
  TimeReader(const SampledTable& table, const ColumnNames& names) : table_(table), names_(names) {}

  std::vector<TimeReading> readings() {
    add_calendar();
    week_ = find(Quantity::Week);
    if (week_ && !table_.columns[*week_].whole) week_.reset();
    for (std::size_t i = 0; i < table_.columns.size(); ++i) {
      const std::optional<Quantity> quantity = names_[i] ? std::optional(names_[i]->quantity) : std::nullopt;
      if (table_.columns[i].date) add_dates(i, std::nullopt, quantity);
      if (table_.columns[i].clock)
        if (const auto day = day_column()) add_dates(i, day, quantity);
      if (table_.columns[i].numeric && std::ranges::find(of_calendar_, i) == of_calendar_.end())
        add_numbers(i, quantity);
    }
    std::ranges::stable_sort(out_, [](const TimeReading& a, const TimeReading& b) { return a.weight > b.weight; });
    return std::move(out_);
  }

 private:
  static constexpr double kVeryEven = 0.02;

  std::optional<std::size_t> find(Quantity quantity) const { return column_called(names_, quantity); }
  std::optional<std::size_t> day_column() const {
    for (std::size_t i = 0; i < table_.columns.size(); ++i)
      if (table_.columns[i].day) return i;
    return std::nullopt;
  }

  void add(TimeReading reading, double weight) {
    constexpr double kUnlikely = 0.3, kMostRows = 0.9;
    reading.weight = weight;
    const auto range = limits_of(reading.times_s);
    if (!range || !goes_up(reading.times_s, reading.by_name)) return;
    std::tie(reading.first_s, reading.last_s) = *range;
    const auto read = std::ranges::count_if(reading.times_s, [](double time_s) { return std::isfinite(time_s); });
    reading.readable = static_cast<double>(read) / static_cast<double>(reading.times_s.size());
    if (!is_possible_rate(rows_per_second(table_, reading))) return;
    reading.rate_unlikely = !is_likely_rate(rows_per_second(table_, reading), reading.last_s - reading.first_s);
    if (reading.rate_unlikely || reading.readable < kMostRows) reading.weight *= kUnlikely;
    out_.push_back(std::move(reading));
  }

  void add_dates(std::size_t column, std::optional<std::size_t> day, std::optional<Quantity> quantity) {
    const std::vector<DateOrder>& orders = table_.columns[day.value_or(column)].orders;
    for (std::size_t i = 0; i < orders.size() && i < 2; ++i) add_dates(column, day, quantity, orders[i], i > 0);
  }

  /// Of GPS where the name says so. @param other by the second of two orders of day and month that are possible
  void add_dates(std::size_t column, std::optional<std::size_t> day, std::optional<Quantity> quantity, DateOrder order,
                 bool other) {
    TimeReading reading;
    reading.columns.date_order = order;
    reading.order_open = table_.columns[day.value_or(column)].orders.size() > 1;
    reading.columns.time = table_.ref(column);
    reading.columns.is_date = true;
    reading.unit = "date";
    reading.at = {column};
    reading.by_name = quantity.has_value();
    reading.unit_by_name = true;
    reading.times_s = other && !day ? table_.columns[column].other_values : table_.columns[column].values;
    if (day) {
      reading.columns.day = table_.ref(*day);
      reading.at.push_back(*day);
      reading.times_s = times_of_day(column, *day, other);
    }
    const bool gps = quantity == Quantity::GpsTime;
    add(reading, gps ? 2.0 : 2.6);
    reading.columns.time_scale = TimeScale::Gps;
    for (double& time_s : reading.times_s)
      if (std::isfinite(time_s)) time_s = unix_s_from_gps_s(time_s - kGpsEpoch_s);
    add(reading, gps ? 2.6 : 0.4);
  }

  /// The text of a day was read as its midnight, and that of a clock as one of no day.
  std::vector<double> times_of_day(std::size_t clock, std::size_t day, bool other) const {
    std::vector<double> times = other ? table_.columns[day].other_values : table_.columns[day].values;
    for (std::size_t i = 0; i < times.size(); ++i) times[i] += std::fmod(table_.columns[clock].values[i], kDay_s);
    return times;
  }

  void add_numbers(std::size_t column, std::optional<Quantity> quantity) {
    const std::vector<double>& values = table_.columns[column].values;
    if (const auto unit_ns = rest_unit_ns(quantity);
        unit_ns && !is_rest_of_second(table_.columns[column], *unit_ns) && goes_up(values, true))
      return add_counted(column, *unit_ns, Quantity::Time, 3.0, true);
    if (const auto rest = find_rest(); rest && are_whole_seconds(column)) return add_in_parts(column, *rest);
    static constexpr Quantity kTimes[] = {Quantity::Time,        Quantity::HostTime, Quantity::GpsTime,
                                          Quantity::WeekSeconds, Quantity::Seconds,  Quantity::Date};
    const bool named = quantity && std::ranges::find(kTimes, *quantity) != std::end(kTimes);
    if (quantity && (!named || !unit_is_read(*names_[column]))) return;
    if (!goes_up(values, named) || (!named && !may_be_unnamed_time(values))) return;
    const std::string unit = named ? names_[column]->unit : "";
    const std::int64_t stated_ns = formats::time_unit_named_ns(unit).value_or(0);
    const bool counts = counts_lines(table_.columns[column]) && stated_ns == 0;
    if (counts && named) return add_counter(column, *quantity);
    const auto unit_ns = stated_ns != 0 ? std::optional(stated_ns) : unit_of(values);
    if (!unit_ns) return;
    const bool host = quantity == Quantity::HostTime;
    double weight = !named ? 0.5 : host ? 1.0 : quantity == Quantity::Time ? 3.0 : 2.8;
    if (counts) weight = std::min(weight, 0.1);
    add_counted(column, *unit_ns, quantity, weight, stated_ns != 0, counts);
    const auto by_size_ns = unit_of(values);
    if (stated_ns == 0 || !by_size_ns || *by_size_ns == stated_ns || may_be_steps(values, stated_ns)) return;
    const std::size_t before = out_.size();
    add_counted(column, *by_size_ns, quantity, weight, false);
    for (std::size_t i = before; i < out_.size(); ++i) out_[i].not_the_unit = unit;
  }

  struct Rest {
    std::size_t column = 0;
    std::int64_t unit_ns = 1;
  };
  std::optional<Rest> find_rest() const {
    for (const auto& [quantity, unit_ns] : kRests)
      if (const auto column = find(quantity); column && is_rest_of_second(table_.columns[*column], unit_ns))
        return Rest{*column, unit_ns};
    return std::nullopt;
  }

  /// By its size, or its even steps: very even ones where another column is called a time.
  bool may_be_unnamed_time(const std::vector<double>& values) {
    const std::vector<double> first = first_values(values);
    if (first.front() > kEarliest_s && formats::unit_of_stamps_ns(first)) return true;
    return has_even_steps(values, some_time_is_sure() ? kVeryEven : 0.5);
  }

  /// By a name, or by steps that nothing but a clock has.
  bool some_time_is_sure() {
    if (!time_is_sure_) time_is_sure_ = look_for_sure_time();
    return *time_is_sure_;
  }
  bool look_for_sure_time() const {
    for (std::size_t i = 0; i < table_.columns.size(); ++i) {
      if (names_[i] && (names_[i]->quantity == Quantity::Time || names_[i]->quantity == Quantity::GpsTime ||
                        names_[i]->quantity == Quantity::WeekSeconds))
        return true;
      const SampledColumn& column = table_.columns[i];
      if (!names_[i] && column.numeric && !counts_lines(column) && goes_up(column.values, false) &&
          has_even_steps(column.values, kVeryEven))
        return true;
    }
    return false;
  }

  bool are_whole_seconds(std::size_t column) const {
    if (!names_[column]) return false;
    const auto& [quantity, unit] = *names_[column];
    const bool named = quantity == Quantity::Seconds || quantity == Quantity::Time;
    return named && table_.columns[column].whole && (unit.empty() || unit == "s") &&
           largest_size(table_.columns[column].values) < kLatest_s;
  }

  /// Whole numbers of one step that are called a time, in no unit that is stated: in each in which rows would follow
  /// each other as those of a log do, the longest in which they do so within a second before the others.
  void add_counter(std::size_t column, Quantity quantity) {
    constexpr double kShortest_s = 1e-4, kUsual_s = 1.0, kLongest_s = 20.0;
    const std::vector<double> first = first_values(table_.columns[column].values);
    bool usual_found = false;
    for (const std::int64_t unit_ns : {1'000'000'000, 1'000'000, 1'000, 1}) {
      const double step_s = (first[1] - first[0]) * 1e-9 * static_cast<double>(unit_ns);
      if (step_s < kShortest_s || step_s > kLongest_s) continue;
      const bool usual = !usual_found && step_s <= kUsual_s;
      usual_found = usual_found || usual;
      add_counted(column, unit_ns, quantity, usual ? 2.0 : 1.8, false);
    }
  }

  std::optional<std::int64_t> unit_of(const std::vector<double>& values) const {
    const std::vector<double> first = first_values(values);
    if (const auto unit_ns = formats::unit_of_stamps_ns(first)) return unit_ns;
    if (const auto unit_ns = unit_of_usual_rate_ns(first)) return unit_ns;
    // Of the week: milliseconds, whose steps may be those of several units.
    if (!first.empty() && first.back() > kWeek_s && first.back() <= kWeek_s * 1e3) return 1'000'000;
    return std::nullopt;
  }

  void put_rest(const Rest& rest, TimeReading& reading) const {
    reading.columns.nanoseconds = table_.ref(rest.column);
    reading.columns.rest_unit_ns = rest.unit_ns;
    reading.at.push_back(rest.column);
    for (std::size_t i = 0; i < reading.times_s.size(); ++i)
      reading.times_s[i] += 1e-9 * static_cast<double>(rest.unit_ns) * table_.columns[rest.column].values[i];
  }

  void add_in_parts(std::size_t column, const Rest& rest) {
    TimeReading reading;
    reading.columns.time = table_.ref(column);
    reading.unit = "s";
    reading.at = {column};
    reading.by_name = reading.unit_by_name = true;
    reading.times_s = table_.columns[column].values;
    put_rest(rest, reading);
    add(reading, 3.2);
  }

  /// A column of numbers that stay within a range.
  std::optional<std::size_t> find_part(std::initializer_list<Quantity> quantities, double least, double most) const {
    for (const Quantity quantity : quantities) {
      const auto column = find(quantity);
      const auto range =
          column && table_.columns[*column].numeric ? limits_of(table_.columns[*column].values) : std::nullopt;
      if (range && range->first >= least && range->second <= most) return column;
    }
    return std::nullopt;
  }

  /// Year, month, day, hour, minute and second in columns of their own.
  void add_calendar() {
    const auto year = find_part({Quantity::Year}, 1980.0, 2100.0), month = find_part({Quantity::Month}, 1.0, 12.0),
               day = find_part({Quantity::MonthDay, Quantity::Date}, 1.0, 31.0),
               hour = find_part({Quantity::Hour}, 0.0, 23.0), minute = find_part({Quantity::Minute}, 0.0, 59.0),
               second = find_part({Quantity::Seconds}, 0.0, 61.0);
    if (!year || !month || !day || !hour || !minute || !second) return;
    of_calendar_ = {*year, *month, *day, *hour, *minute, *second};
    TimeReading reading;
    reading.columns.time = table_.ref(*second);
    reading.columns.calendar = {table_.ref(*year), table_.ref(*month), table_.ref(*day), table_.ref(*hour),
                                table_.ref(*minute)};
    reading.unit = "s";
    reading.at = {*year, *month, *day, *hour, *minute, *second};
    reading.by_name = reading.unit_by_name = true;
    for (std::size_t i = 0; i < table_.columns[*year].values.size(); ++i) {
      const auto value = [&](const std::optional<std::size_t>& part) { return table_.columns[*part].values[i]; };
      const std::array parts{value(year), value(month), value(day), value(hour), value(minute), value(second)};
      reading.times_s.push_back(calendar_s(parts));
    }
    if (const auto rest = find_rest(); rest && table_.columns[*second].whole) put_rest(*rest, reading);
    add(reading, 3.4);
    reading.columns.time_scale = TimeScale::Gps;
    for (double& time_s : reading.times_s)
      if (std::isfinite(time_s)) time_s = unix_s_from_gps_s(time_s - kGpsEpoch_s);
    add(reading, 0.4);
  }

  static double calendar_s(const std::array<double, 6>& parts) {
    std::array<int, 6> whole{};
    for (std::size_t i = 0; i < whole.size(); ++i) {
      if (!std::isfinite(parts[i])) return kNotATime;
      whole[i] = static_cast<int>(parts[i]);
    }
    const auto date_ns = formats::date_of_parts_ns(whole, 0);
    return date_ns ? 1e-9 * static_cast<double>(*date_ns) + parts[5] - whole[5] : kNotATime;
  }

  void add_counted(std::size_t column, std::int64_t unit_ns, std::optional<Quantity> quantity, double weight,
                   bool unit_by_name, bool counts = false) {
    TimeReading reading;
    reading.columns.time = table_.ref(column);
    reading.columns.time_unit_ns = unit_ns;
    reading.unit = formats::time_unit_name(unit_ns);
    reading.at = {column};
    reading.by_name = quantity.has_value();
    reading.unit_by_name = unit_by_name;
    reading.counts = counts;
    std::vector<double> counted_s = table_.columns[column].values;
    for (double& value : counted_s) value *= 1e-9 * static_cast<double>(unit_ns);
    const double first_s = first_values(counted_s).front();
    const bool of_week = first_s >= 0.0 && first_s <= kWeek_s;
    const bool says_week = quantity == Quantity::WeekSeconds;
    const auto in_scale = [&](TimeScale scale, double with_weight) {
      reading.columns.time_scale = scale;
      reading.columns.gps_week.reset();
      reading.times_s = scale == TimeScale::GpsWeek ? over_weeks(counted_s) : counted_s;
      if (scale != TimeScale::Unix)
        for (double& time_s : reading.times_s)
          if (std::isfinite(time_s)) time_s = unix_s_from_gps_s(time_s);
      add(reading, with_weight);
    };
    if (of_week && week_for(column, quantity)) add_with_week(reading, counted_s, *week_for(column, quantity), weight);
    if (of_week && (says_week || quantity == Quantity::GpsTime)) return in_scale(TimeScale::GpsWeek, 0.9 * weight);
    const bool since_1980 = quantity == Quantity::GpsTime && first_s > kEarliest_s;
    in_scale(TimeScale::Unix, since_1980 ? 0.6 * weight : weight);
    if (first_s > kEarliest_s && first_s < kLatest_s) in_scale(TimeScale::Gps, since_1980 ? weight : 0.3 * weight);
    if (of_week) in_scale(TimeScale::GpsWeek, 0.3 * weight);
  }

  /// By its name, or the whole number beside a time of the week that no name explains.
  std::optional<std::size_t> week_for(std::size_t column, std::optional<Quantity> quantity) const {
    if (week_ || quantity) return week_;
    constexpr double kFirst = 1000.0, kLast = 4000.0;
    for (const std::size_t beside : {column - 1, column + 1}) {
      if (beside >= table_.columns.size() || names_[beside] || !table_.columns[beside].whole) continue;
      const std::vector<double>& weeks = table_.columns[beside].values;
      const auto [least, most] = std::ranges::minmax_element(weeks);
      if (*least >= kFirst && *most <= kLast && *most - *least <= 1.0) return beside;
    }
    return std::nullopt;
  }

  void add_with_week(TimeReading reading, const std::vector<double>& counted_s, std::size_t week, double weight) {
    reading.columns.time_scale = TimeScale::Gps;
    reading.columns.gps_week = table_.ref(week);
    reading.at.push_back(week);
    reading.times_s = counted_s;
    for (std::size_t i = 0; i < reading.times_s.size(); ++i) {
      const double gps_s = table_.columns[week].values[i] * kWeek_s + counted_s[i];
      reading.times_s[i] =
          std::isfinite(gps_s) && gps_s > 0.0 && gps_s < kLatest_s ? unix_s_from_gps_s(gps_s) : kNotATime;
    }
    add(std::move(reading), weight + 0.5);
  }

  const SampledTable& table_;
  const ColumnNames& names_;
  std::optional<std::size_t> week_;
  std::optional<bool> time_is_sure_;
  std::vector<std::size_t> of_calendar_;  ///< columns
  std::vector<TimeReading> out_;
};

}  // namespace

double unix_s_from_gps_s(double gps_s) {
  if (!(std::abs(gps_s) < 2.0 * kLatest_s)) return kNotATime;
  return gps_s + kGpsEpoch_s - formats::leap_seconds_at_gps_s(static_cast<std::int64_t>(gps_s));
}

std::vector<TimeReading> time_readings(const SampledTable& table, const ColumnNames& names) {
  return TimeReader(table, names).readings();
}

double rows_per_second(const SampledTable& table, const TimeReading& reading) {
  const double span_s = reading.last_s - reading.first_s;
  return span_s > 0.0 ? static_cast<double>(table.rows - 1) / span_s : 0.0;
}

}  // namespace remount::guesses
