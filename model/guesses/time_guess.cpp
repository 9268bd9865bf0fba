#include "model/guesses/time_guess.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "algorithms/core/median.h"
#include "messages/guesses.h"
#include "model/formats/files/time_stamp.h"
#include "model/formats/files/time_unit.h"
#include "model/formats/poses/pose_columns.h"

namespace remount::guesses {
namespace {

using formats::DateOrder;
using formats::TimeColumns;
using formats::TimeScale;

constexpr double kWeek_s = 604'800.0, kDay_s = 86'400.0;
constexpr double kEarliest_s = 3e8, kLatest_s = 4.1e9;  // 1979 to 2099
constexpr double kGpsEpoch_s = 1e-9 * static_cast<double>(formats::kGpsEpoch_ns);
constexpr double kNotATime = std::numeric_limits<double>::quiet_NaN();

/// Numbers that are no time of any clock are none here.
double unix_s_from_gps_s(double gps_s) {
  if (!(std::abs(gps_s) < 2.0 * kLatest_s)) return kNotATime;
  return gps_s + kGpsEpoch_s - formats::leap_seconds_at_gps_s(static_cast<std::int64_t>(gps_s));
}

/// Most steps lead on, others stay (stamps may be rounded), and hardly any leads back.
bool goes_up(const std::vector<double>& values) {
  std::size_t up = 0, down = 0, steps = 0;
  double before = kNotATime;
  for (const double value : values) {
    if (!std::isfinite(value)) continue;
    if (std::isfinite(before)) ++steps, up += value > before, down += value < before;
    before = value;
  }
  return steps >= 4 && 2 * up >= steps && 100 * down <= steps;
}

/// Whole numbers that go up by one: of lines.
bool counts_lines(const SampledColumn& column) {
  if (!column.whole) return false;
  const double step = column.values.size() > 1 ? column.values[1] - column.values[0] : 0.0;
  std::size_t other = 0;
  for (std::size_t i = 1; i < column.values.size(); ++i) other += column.values[i] - column.values[i - 1] != step;
  return other * 100 < column.values.size() && column.values.front() >= 0.0 && column.values.front() < 1e7 &&
         step > 0.0 && step < 1e4;
}

std::vector<double> first_values(const std::vector<double>& values) {
  constexpr std::size_t kEnough = 200;
  std::vector<double> first;
  for (const double value : values)
    if (std::isfinite(value) && first.size() < kEnough) first.push_back(value);
  return first;
}

/// Seconds of the week that go on over its end.
std::vector<double> over_weeks(std::vector<double> of_week_s) {
  double weeks_s = 0.0, before_s = kNotATime;
  for (double& time_s : of_week_s) {
    if (!std::isfinite(time_s)) continue;
    if (time_s + weeks_s < before_s - 0.5 * kWeek_s) weeks_s += kWeek_s;
    time_s += weeks_s;
    before_s = time_s;
  }
  return of_week_s;
}

/// Beside whole seconds: none reaches a second.
bool is_rest_of_second(const SampledColumn& column) {
  const std::vector<double> first = first_values(column.values);
  return column.numeric && std::ranges::all_of(first, [](double value) { return value >= 0.0 && value < 1e9; });
}

class TimeReader {
 public:
  TimeReader(const SampledTable& table, const ColumnNames& names) : table_(table), names_(names) {}

  std::vector<TimeReading> readings() {
    week_ = find(Quantity::Week);
    if (week_ && !table_.columns[*week_].whole) week_.reset();
    for (std::size_t i = 0; i < table_.columns.size(); ++i) {
      const std::optional<Quantity> quantity = names_[i] ? std::optional(names_[i]->quantity) : std::nullopt;
      if (table_.columns[i].date) add_dates(i, std::nullopt, quantity);
      if (table_.columns[i].clock)
        if (const auto day = day_column()) add_dates(i, day, quantity);
      if (table_.columns[i].numeric) add_numbers(i, quantity);
    }
    std::ranges::stable_sort(out_, [](const TimeReading& a, const TimeReading& b) { return a.weight > b.weight; });
    return std::move(out_);
  }

 private:
  std::optional<std::size_t> find(Quantity quantity) const { return column_called(names_, quantity); }
  std::optional<std::size_t> day_column() const {
    for (std::size_t i = 0; i < table_.columns.size(); ++i)
      if (table_.columns[i].day) return i;
    return std::nullopt;
  }

  void add(TimeReading reading, double weight) {
    reading.weight = weight;
    if (!goes_up(reading.times_s)) return;
    reading.first_s = std::numeric_limits<double>::infinity();
    reading.last_s = -reading.first_s;
    for (const double time_s : reading.times_s)
      if (std::isfinite(time_s))
        reading.first_s = std::min(reading.first_s, time_s), reading.last_s = std::max(reading.last_s, time_s);
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
    if (quantity == Quantity::Nanoseconds && !is_rest_of_second(table_.columns[column]) && goes_up(values))
      return add_counted(column, 1, Quantity::Time, 3.0, true);
    const auto rest = find(Quantity::Nanoseconds);
    if (rest && is_rest_of_second(table_.columns[*rest]) && are_whole_seconds(column))
      return add_in_parts(column, *rest);
    static constexpr Quantity kTimes[] = {Quantity::Time,        Quantity::HostTime, Quantity::GpsTime,
                                          Quantity::WeekSeconds, Quantity::Seconds,  Quantity::Date};
    const bool named = quantity && std::ranges::find(kTimes, *quantity) != std::end(kTimes);
    if (quantity && (!named || !unit_is_read(*names_[column]))) return;
    if (!goes_up(values)) return;
    const std::string unit = named ? names_[column]->unit : "";
    const std::int64_t stated_ns = formats::time_unit_named_ns(unit).value_or(0);
    const bool counts = counts_lines(table_.columns[column]) && stated_ns == 0;
    if (counts && named) return add_counter(column, *quantity);
    const auto unit_ns = stated_ns != 0 ? std::optional(stated_ns) : unit_of(values);
    if (!unit_ns) return;
    const bool host = quantity == Quantity::HostTime;
    double weight = !named ? 0.5 : host ? 1.0 : quantity == Quantity::Time ? 3.0 : 2.8;
    if (counts) weight = std::min(weight, 0.1);
    add_counted(column, *unit_ns, quantity, weight, stated_ns != 0);
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
    // Of the week: milliseconds, whose steps may be those of several units.
    if (!first.empty() && first.back() > kWeek_s && first.back() <= kWeek_s * 1e3) return 1'000'000;
    return std::nullopt;
  }

  void add_in_parts(std::size_t column, std::size_t rest) {
    TimeReading reading;
    reading.columns.time = table_.ref(column);
    reading.columns.nanoseconds = table_.ref(rest);
    reading.unit = "s";
    reading.at = {column, rest};
    reading.by_name = reading.unit_by_name = true;
    reading.times_s = table_.columns[column].values;
    for (std::size_t i = 0; i < reading.times_s.size(); ++i)
      reading.times_s[i] += 1e-9 * table_.columns[rest].values[i];
    add(reading, 3.2);
  }

  void add_counted(std::size_t column, std::int64_t unit_ns, std::optional<Quantity> quantity, double weight,
                   bool unit_by_name) {
    TimeReading reading;
    reading.columns.time = table_.ref(column);
    reading.columns.time_unit_ns = unit_ns;
    reading.unit = formats::time_unit_name(unit_ns);
    reading.at = {column};
    reading.by_name = quantity.has_value();
    reading.unit_by_name = unit_by_name;
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
  std::vector<TimeReading> out_;
};

Message scale_words(const TimeReading& reading) {
  if (reading.columns.gps_week) return say::guess_time_of_week();
  if (reading.week_open()) return say::guess_time_of_open_week();
  if (reading.columns.time_scale == TimeScale::Gps) return say::guess_time_since_1980();
  return reading.first_s > kEarliest_s ? say::guess_time_utc() : say::guess_time_of_its_own();
}

/// How another reading is written, for a comment.
Message alternative_of(const SampledTable& table, const TimeReading& reading, const TimeReading& ours, double apart_s) {
  std::vector<std::string> columns;
  for (const std::size_t column : reading.at) columns.push_back(table.label(column));
  if (reading.columns.is_date && reading.columns.date_order != ours.columns.date_order) {
    const std::string order(date_order_name(reading.columns.date_order));
    if (reading.columns.time_scale == ours.columns.time_scale)
      return say::guess_date_alternative(std::move(columns), order, Duration{apart_s});
    return say::guess_date_clock_alternative(std::move(columns), order, scale_words(reading), Duration{apart_s});
  }
  if (apart_s == 0.0)
    return say::guess_unit_alternative(std::move(columns), reading.unit, Duration{reading.last_s - reading.first_s});
  return say::guess_time_alternative(std::move(columns), reading.unit, scale_words(reading), Duration{apart_s});
}

constexpr double kSame_s = 1e-3;

/// Of the first times, 0 where they are the same.
double apart(const TimeReading& a, const TimeReading& b) {
  const double apart_s = a.first_s - b.first_s;
  return std::abs(apart_s) < kSame_s ? 0.0 : apart_s;
}

bool differ(const TimeReading& a, const TimeReading& b) {
  return apart(a, b) != 0.0 || std::abs(a.last_s - b.last_s) >= kSame_s;
}

/// Whether another way to read the same columns has none of as many stamps within.
bool stamps_tell(const std::vector<TimeReading>& readings, std::size_t chosen,
                 const std::vector<std::int64_t>& stamps_ns) {
  const TimeReading& ours = readings[chosen];
  const std::size_t inside = within(ours, stamps_ns);
  return inside > 0 && std::ranges::none_of(readings, [&](const TimeReading& other) {
           return &other != &ours && other.at == ours.at && differ(other, ours) && within(other, stamps_ns) >= inside;
         });
}

void say_alternatives(const SampledTable& table, const std::vector<TimeReading>& readings, std::size_t chosen,
                      const std::vector<std::int64_t>& stamps_ns, Guess& guess) {
  const TimeReading& ours = readings[chosen];
  const std::size_t inside = within(ours, stamps_ns);
  for (std::size_t i = 0; i < readings.size(); ++i) {
    const TimeReading& other = readings[i];
    const double apart_s = apart(other, ours);
    const bool other_column = other.at.front() != ours.at.front();
    const bool as_good = !other_column && inside > 0 && within(other, stamps_ns) >= inside;
    // What lies away from scans that the chosen one covers is no alternative; what is hardly likely neither.
    const bool refuted = !stamps_ns.empty() && 2 * within(other, stamps_ns) < inside;
    if (i == chosen || !differ(other, ours)) continue;
    if (!as_good && (other.weight < 0.2 * ours.weight || (refuted && !other_column))) continue;
    if (!as_good && !other_column && other.weight < 0.5 * ours.weight) continue;
    guess.alternatives.push_back(alternative_of(table, other, ours, apart_s));
    static_cast<TimeColumns&>(guess.other_layouts.emplace_back()) = other.columns;
    if (!refuted && other.weight >= 0.8 * ours.weight) guess.sureness = Sureness::Open;
  }
}

}  // namespace

std::vector<TimeReading> time_readings(const SampledTable& table, const ColumnNames& names) {
  return TimeReader(table, names).readings();
}

std::size_t within(const TimeReading& reading, const std::vector<std::int64_t>& stamps_ns) {
  return static_cast<std::size_t>(std::ranges::count_if(stamps_ns, [&](std::int64_t stamp_ns) {
    const auto inside = [&](double time_s) { return time_s >= reading.first_s && time_s <= reading.last_s; };
    if (!reading.week_open()) return inside(1e-9 * static_cast<double>(stamp_ns));
    // A week that nobody names is that of the scans, or the one before where the log goes on over its end.
    const double of_week_s = std::fmod(1e-9 * static_cast<double>(formats::gps_ns_from_unix_ns(stamp_ns)), kWeek_s);
    return inside(unix_s_from_gps_s(of_week_s)) || inside(unix_s_from_gps_s(of_week_s + kWeek_s));
  }));
}

std::optional<ChosenTime> choose_time(const SampledTable& table, const ColumnNames& names,
                                      const std::vector<std::int64_t>& stamps_ns) {
  const std::vector<TimeReading> readings = time_readings(table, names);
  if (readings.empty()) return std::nullopt;
  std::size_t chosen = 0, most = 0;
  for (std::size_t i = 0; i < readings.size(); ++i) {
    const std::size_t inside = within(readings[i], stamps_ns);
    if (10 * inside > 11 * most && 2 * inside >= stamps_ns.size()) chosen = i, most = inside;
  }
  const TimeReading& reading = readings[chosen];
  Guess guess{GuessKind::Time, {}, reading.unit, reading.by_name ? Sureness::Named : Sureness::Likely, {}, {}};
  for (const std::size_t column : reading.at) guess.columns.push_back(table.label(column));
  guess.evidence.push_back(scale_words(reading));
  if (reading.columns.date_order != DateOrder::YearFirst)
    guess.evidence.push_back(
        say::guess_date_order(words(reading.columns.date_order),
                              reading.order_open ? say::guess_date_order_open() : say::guess_date_order_told()));
  if (!reading.unit_by_name) guess.evidence.push_back(say::guess_unit_by_size(reading.unit));
  if (!reading.by_name) guess.evidence.push_back(say::guess_time_by_going_up());
  say_alternatives(table, readings, chosen, stamps_ns, guess);
  const bool checked = reading.first_s > kEarliest_s && stamps_tell(readings, chosen, stamps_ns);
  if (checked && guess.sureness != Sureness::Open) guess.sureness = Sureness::Checked;
  return ChosenTime{reading, std::move(guess)};
}

double rows_per_second(const SampledTable& table, const TimeReading& reading) {
  const double span_s = reading.last_s - reading.first_s;
  return span_s > 0.0 ? static_cast<double>(table.rows - 1) / span_s : 0.0;
}

}  // namespace remount::guesses
