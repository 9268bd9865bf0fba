#include "model/guesses/named_columns.h"

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
    if (names[i] && names[i]->quantity == quantity && table.columns[i].numeric) return i;
  return std::nullopt;
}

}  // namespace remount::guesses
