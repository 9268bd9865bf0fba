// Which column of a table is called what.
#pragma once

#include <optional>
#include <vector>

#include "model/guesses/column_names.h"
#include "model/guesses/sampled_table.h"

namespace remount::guesses {

/// Of each column; nothing where its name says nothing.
using ColumnNames = std::vector<std::optional<NamedQuantity>>;
ColumnNames names_of(const SampledTable& table);

/// The first column that is called so.
std::optional<std::size_t> column_called(const ColumnNames& names, Quantity quantity);

/// The first that is called so and holds numbers.
std::optional<std::size_t> number_column(const SampledTable& table, const ColumnNames& names, Quantity quantity);

}  // namespace remount::guesses
