#include "model/guesses/time_guess.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "messages/guesses.h"
#include "messages/table_import.h"
#include "model/formats/files/running_period.h"
#include "model/formats/files/time_stamp.h"
#include "model/guesses/time_steps.h"

namespace remount::guesses {
namespace {

using formats::DateOrder;
using formats::TimeColumns;
using formats::TimeScale;

Message scale_words(const TimeReading& reading) {
  if (reading.columns.gps_week) return say::guess_time_of_week();
  if (reading.week_open()) return say::guess_time_of_open_week();
  if (reading.columns.time_scale == TimeScale::Gps) return say::guess_time_since_1980();
  if (reading.columns.calendar) return say::guess_time_in_columns();
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

/// Whether as many of the stamps lie within where they are moved by the difference between GPS time and UTC, either
/// way: which of the two it is cannot be told then.
bool holds_leap_seconds(const TimeReading& reading, const std::vector<std::int64_t>& stamps_ns) {
  if (stamps_ns.empty()) return false;
  const std::size_t inside = within(reading, stamps_ns);
  const std::int64_t gps_s = formats::gps_ns_from_unix_ns(stamps_ns.front()) / 1'000'000'000;
  const std::int64_t leap_ns = std::int64_t{1'000'000'000} * formats::leap_seconds_at_gps_s(gps_s);
  return std::ranges::all_of(std::array{leap_ns, -leap_ns}, [&](std::int64_t moved_ns) {
    std::vector<std::int64_t> moved = stamps_ns;
    for (std::int64_t& stamp_ns : moved) stamp_ns += moved_ns;
    return within(reading, moved) >= inside;
  });
}

/// What few rows have, or no log is recorded with, is not sure.
void doubt(const TimeReading& reading, Guess& guess) {
  constexpr double kMostRows = 0.9;
  if (reading.readable < kMostRows) guess.evidence.push_back(say::guess_time_of_some_rows(Share{reading.readable}));
  if (reading.rate_unlikely) guess.evidence.push_back(say::import_rate_unlikely());
  if (reading.readable >= kMostRows && !reading.rate_unlikely) return;
  if (guess.sureness != Sureness::Open) guess.sureness = Sureness::Likely;
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

std::int64_t gps_week_of(double unix_s) {
  return formats::gps_ns_from_unix_ns(static_cast<std::int64_t>(unix_s) * 1'000'000'000) / formats::kGpsWeek_ns;
}

/// "2023-11-12", when a week of GPS begins.
std::string first_day_of(std::int64_t gps_week) {
  constexpr std::size_t kDay = 10;
  constexpr std::int64_t kMinute_ns = 60'000'000'000;  // by the leap seconds it begins in the evening before, in UTC
  return formats::format_date_ns(formats::unix_ns_from_gps_ns(gps_week * formats::kGpsWeek_ns + kMinute_ns))
      .substr(0, kDay);
}

/// A column that names another week than that of the scans, which was taken: one of the two is wrong, and which, no
/// number tells. Where they are turns of the count apart, the receiver's began anew.
void doubt_named_week(const SampledTable& table, const std::vector<TimeReading>& readings, std::size_t chosen,
                      const std::vector<std::int64_t>& stamps_ns, Guess& guess) {
  const TimeReading& ours = readings[chosen];
  if (!ours.week_open() || stamps_ns.empty()) return;
  const auto named = std::ranges::find_if(readings, [&](const TimeReading& other) {
    return other.columns.gps_week && other.at.front() == ours.at.front();
  });
  if (named == readings.end()) return;
  const std::int64_t week = gps_week_of(named->first_s),
                     of_scans = gps_week_of(1e-9 * static_cast<double>(stamps_ns[stamps_ns.size() / 2]));
  const std::string column = table.label(named->at.back());
  const bool turned = (of_scans - week) % formats::kGpsWeeksOfTurn == 0;
  guess.evidence.front() =
      turned ? say::guess_week_began_anew(column, week, of_scans)
             : say::guess_week_contradicts(column, week, first_day_of(week), of_scans, first_day_of(of_scans));
  if (!turned)
    guess.sureness = Sureness::Open;
  else if (guess.sureness != Sureness::Open)
    guess.sureness = Sureness::Likely;
}

}  // namespace

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
  if (!reading.not_the_unit.empty()) {
    guess.evidence.push_back(say::guess_unit_against_title(reading.not_the_unit, reading.unit));
    guess.sureness = Sureness::Likely;
  } else if (!reading.unit_by_name) {
    guess.evidence.push_back(say::guess_unit_by_size(reading.unit));
  }
  if (!reading.by_name) guess.evidence.push_back(say::guess_time_by_going_up());
  say_alternatives(table, readings, chosen, stamps_ns, guess);
  const bool told = reading.first_s > kEarliest_s && stamps_tell(readings, chosen, stamps_ns);
  const bool checked = told && !holds_leap_seconds(reading, stamps_ns) && guess.sureness != Sureness::Open;
  if (checked) guess.sureness = Sureness::Checked;
  doubt_named_week(table, readings, chosen, stamps_ns, guess);
  doubt(reading, guess);
  return ChosenTime{reading, std::move(guess)};
}

}  // namespace remount::guesses
