#include "model/guesses/unread_times.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "messages/guesses.h"

namespace remount::guesses {
namespace {

bool is_called_time(const std::optional<NamedQuantity>& name) {
  static constexpr Quantity kOfTimes[] = {Quantity::Time,        Quantity::GpsTime, Quantity::HostTime,
                                          Quantity::WeekSeconds, Quantity::Date,    Quantity::Seconds};
  return name && unit_is_read(*name) && std::ranges::find(kOfTimes, name->quantity) != std::end(kOfTimes);
}

std::string shortest_text(double number) {
  std::string text = std::to_string(number);
  text.erase(text.find_last_not_of('0') + 1);
  if (text.ends_with('.')) text.pop_back();
  return text;
}

/// Of numbers that are called a time.
Message why_not_numbers(const SampledTable& table, const SampledColumn& column) {
  std::vector<double> known;
  for (const double value : column.values)
    if (std::isfinite(value)) known.push_back(value);
  const std::string label = table.label(column.index);
  if (known.empty()) return say::guess_time_without_values(label);
  std::size_t up = 0, down = 0;
  for (std::size_t i = 1; i < known.size(); ++i) up += known[i] > known[i - 1], down += known[i] < known[i - 1];
  const std::string first = shortest_text(known.front()), last = shortest_text(known.back());
  if (up == 0 || 100 * down > known.size()) return say::guess_time_not_up(label, first, last);
  return say::guess_time_of_no_unit(label, first, last);
}

std::vector<Message> unread_times(const SampledTable& table, const ColumnNames& names) {
  const bool days = std::ranges::any_of(table.columns, &SampledColumn::day);
  std::vector<Message> why;
  for (const SampledColumn& column : table.columns) {
    const std::string label = table.label(column.index);
    const std::string example = column.texts.empty() ? "" : column.texts.front();
    if (column.clock && !days)
      why.push_back(say::guess_time_of_day_alone(label, example));
    else if (!is_called_time(names[column.index]) || column.day)
      continue;
    else if (column.numeric)
      why.push_back(why_not_numbers(table, column));
    else if (column.date || column.clock)
      why.push_back(say::guess_time_not_up(label, example, column.texts.empty() ? "" : column.texts.back()));
    else
      why.push_back(example.empty() ? say::guess_time_without_values(label) : say::guess_time_not_read(label, example));
  }
  return why;
}

}  // namespace

std::vector<Message> why_no_time(const SampledTable& table, const ColumnNames& names) {
  std::vector<Message> why = unread_times(table, names);
  if (why.empty()) why.push_back(say::guess_no_time());
  return why;
}

bool has_unread_time(const SampledTable& table, const ColumnNames& names) {
  return !unread_times(table, names).empty();
}

}  // namespace remount::guesses
