#include "model/guesses/time_steps.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "algorithms/core/median.h"

namespace remount::guesses {

bool goes_up(const std::vector<double>& values, bool by_name) {
  std::size_t up = 0, down = 0, steps = 0;
  double before = std::numeric_limits<double>::quiet_NaN();
  for (const double value : values) {
    if (!std::isfinite(value)) continue;
    if (std::isfinite(before)) ++steps, up += value > before, down += value < before;
    before = value;
  }
  const std::size_t of_ten = by_name ? 1 : 5;
  return steps >= 4 && 10 * up >= of_ten * steps && 100 * down <= steps;
}

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

std::vector<double> over_weeks(std::vector<double> of_week_s) {
  double weeks_s = 0.0, before_s = std::numeric_limits<double>::quiet_NaN();
  for (double& time_s : of_week_s) {
    if (!(time_s >= 0.0 && time_s <= kWeek_s)) time_s = std::numeric_limits<double>::quiet_NaN();
    if (!std::isfinite(time_s)) continue;
    if (time_s + weeks_s < before_s - 0.5 * kWeek_s) weeks_s += kWeek_s;
    time_s += weeks_s;
    before_s = time_s;
  }
  return of_week_s;
}

bool is_rest_of_second(const SampledColumn& column, std::int64_t unit_ns) {
  const double second = 1e9 / static_cast<double>(unit_ns);
  return column.numeric &&
         std::ranges::all_of(first_values(column.values), [&](double value) { return value >= 0.0 && value < second; });
}

bool has_even_steps(const std::vector<double>& values, double tolerance) {
  std::vector<double> steps;
  const std::vector<double> first = first_values(values);
  for (std::size_t i = 1; i < first.size(); ++i) steps.push_back(first[i] - first[i - 1]);
  if (steps.empty()) return false;
  const double usual = median_of(steps);
  const auto alike =
      std::ranges::count_if(steps, [&](double step) { return std::abs(step - usual) <= tolerance * std::abs(usual); });
  return usual > 0.0 && 10 * static_cast<std::size_t>(alike) >= 8 * steps.size();
}

std::optional<std::pair<double, double>> limits_of(const std::vector<double>& values) {
  std::optional<std::pair<double, double>> range;
  for (const double value : values) {
    if (!std::isfinite(value)) continue;
    if (!range) range = {value, value};
    range->first = std::min(range->first, value), range->second = std::max(range->second, value);
  }
  return range;
}

bool is_possible_rate(double rate_hz) { return rate_hz > 1e-3 && rate_hz < 1e5; }

bool is_likely_rate(double rate_hz, double span_s) {
  constexpr double kSlowest_hz = 0.05, kFastest_hz = 2500.0, kLongest_s = 172'800.0;
  return rate_hz >= kSlowest_hz && rate_hz <= kFastest_hz && span_s <= kLongest_s;
}

namespace {

/// The median of those that lead on; 0 where none does.
double usual_step(const std::vector<double>& values) {
  std::vector<double> steps;
  for (std::size_t i = 1; i < values.size(); ++i)
    if (values[i] > values[i - 1]) steps.push_back(values[i] - values[i - 1]);
  return steps.empty() ? 0.0 : median_of(std::move(steps));
}

}  // namespace

bool may_be_steps(const std::vector<double>& values, std::int64_t unit_ns) {
  constexpr double kShortest_s = 1e-4, kLongest_s = 60.0;
  const double step_s = usual_step(first_values(values)) * 1e-9 * static_cast<double>(unit_ns);
  return step_s >= kShortest_s && step_s <= kLongest_s;
}

std::optional<std::int64_t> unit_of_usual_rate_ns(const std::vector<double>& first) {
  constexpr double kShortest_s = 4e-4, kLongest_s = 1.0;
  const double step = usual_step(first);
  std::vector<std::int64_t> usual;
  for (const std::int64_t unit_ns : {1'000'000'000, 1'000'000, 1'000, 1})
    if (const double step_s = step * 1e-9 * static_cast<double>(unit_ns); step_s >= kShortest_s && step_s <= kLongest_s)
      usual.push_back(unit_ns);
  return usual.size() == 1 ? std::optional(usual.front()) : std::nullopt;
}

}  // namespace remount::guesses
