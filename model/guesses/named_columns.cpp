#include "model/guesses/named_columns.h"

#include <initializer_list>
#include <map>
#include <utility>

#include "messages/guesses.h"

namespace remount::guesses {

ColumnNames names_of(const SampledTable& table) {
  ColumnNames names;
  for (const SampledColumn& column : table.columns) names.push_back(quantity_of(column.title, column.unit));
  return names;
}

std::optional<std::size_t> column_called(const ColumnNames& names, Quantity quantity) {
  for (std::size_t i = 0; i < names.size(); ++i)
    if (names[i] && names[i]->quantity == quantity) return i;
  return std::nullopt;
}

std::optional<std::size_t> number_column(const SampledTable& table, const ColumnNames& names, Quantity quantity) {
  for (std::size_t i = 0; i < names.size(); ++i)
    if (names[i] && names[i]->quantity == quantity && table.columns[i].numeric && unit_is_read(*names[i])) return i;
  return std::nullopt;
}

std::vector<std::string> others_called_alike(const SampledTable& table, const ColumnNames& names, std::size_t column) {
  std::vector<std::string> others;
  for (std::size_t i = 0; i < names.size(); ++i)
    if (i != column && names[i] && names[column] && names[i]->quantity == names[column]->quantity &&
        table.columns[i].numeric && unit_is_read(*names[i]))
      others.push_back(table.label(i) + " (" + std::to_string(i) + ")");
  return others;
}

std::optional<std::string> common_unit(const ColumnNames& names, std::span<const std::size_t> columns) {
  std::string unit;
  for (const std::size_t column : columns) {
    if (!names[column] || names[column]->unit.empty() || names[column]->unit == unit) continue;
    if (!unit.empty()) return std::nullopt;
    unit = names[column]->unit;
  }
  return unit;
}

std::vector<Message> unread_units(const SampledTable& table, const ColumnNames& names) {
  std::map<std::pair<std::string, std::vector<std::string_view>>, std::vector<std::string>> columns_by_unit;
  for (std::size_t i = 0; i < names.size(); ++i)
    if (names[i] && !unit_is_read(*names[i]))
      columns_by_unit[{names[i]->unit, units_read(names[i]->quantity)}].push_back(table.label(i));
  std::vector<Message> unread;
  for (const auto& [units, columns] : columns_by_unit)
    unread.push_back(say::guess_unit_not_read(units.first, columns, {units.second.begin(), units.second.end()}));
  const auto tell_several = [&](std::initializer_list<Quantity> quantities) {
    std::vector<std::size_t> columns;
    for (const Quantity quantity : quantities)
      if (const auto column = number_column(table, names, quantity)) columns.push_back(*column);
    if (common_unit(names, columns)) return;
    std::vector<std::string> labels;
    for (const std::size_t column : columns) labels.push_back(table.label(column));
    unread.push_back(say::guess_units_differ(std::move(labels)));
  };
  tell_several({Quantity::Latitude, Quantity::Longitude});
  tell_several({Quantity::Roll, Quantity::Pitch, Quantity::Heading, Quantity::Yaw});
  return unread;
}

}  // namespace remount::guesses
