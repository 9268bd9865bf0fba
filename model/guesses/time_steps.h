// How numbers go from row to row: as times do, or as what is counted and measured.
#pragma once

#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "model/guesses/sampled_table.h"

namespace remount::guesses {

inline constexpr double kWeek_s = 604'800.0;

/// Whether steps lead on or stay (stamps may be rounded, rows written twice), and hardly any leads back.
bool goes_up(const std::vector<double>& values, bool by_name);

/// Whole numbers that go up by one: of lines.
bool counts_lines(const SampledColumn& column);

/// Some of those that are numbers.
std::vector<double> first_values(const std::vector<double>& values);

/// Seconds of the week that go on over its end.
std::vector<double> over_weeks(std::vector<double> of_week_s);

/// Beside whole seconds: none reaches a second. @param unit_ns that it counts
bool is_rest_of_second(const SampledColumn& column, std::int64_t unit_ns);

/// As a clock's, which is read in even steps: most are alike. Ways and places go up as well.
bool has_even_steps(const std::vector<double>& values, double tolerance);

/// The smallest and the largest; nothing where there is none.
std::optional<std::pair<double, double>> limits_of(const std::vector<double>& values);

/// Whether times in that unit follow each other as those of a log may.
bool may_be_steps(const std::vector<double>& values, std::int64_t unit_ns);

bool is_possible_rate(double rate_hz);
/// Of a log of an INS.
bool is_likely_rate(double rate_hz, double span_s);

/// The only unit in which such times follow each other as those of an INS do; nothing where none or several are.
std::optional<std::int64_t> unit_of_usual_rate_ns(const std::vector<double>& first);

}  // namespace remount::guesses
