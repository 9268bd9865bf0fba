// Which column of a table is called what.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "algorithms/messages/message.h"
#include "model/guesses/column_names.h"
#include "model/guesses/sampled_table.h"

namespace remount::guesses {

/// Of each column; nothing where its name says nothing.
using ColumnNames = std::vector<std::optional<NamedQuantity>>;
ColumnNames names_of(const SampledTable& table);

/// The first column that is called so.
std::optional<std::size_t> column_called(const ColumnNames& names, Quantity quantity);

/// The first that is called so and holds numbers in a unit that is read.
std::optional<std::size_t> number_column(const SampledTable& table, const ColumnNames& names, Quantity quantity);

/// Others that hold numbers of the same quantity, as far as names say: "heading (7)", counted from 0.
std::vector<std::string> others_called_alike(const SampledTable& table, const ColumnNames& names, std::size_t column);

/// The unit that those columns state; empty where none does, and nothing where they state several.
std::optional<std::string> common_unit(const ColumnNames& names, std::span<const std::size_t> columns);

/// What keeps columns from being read: a unit that is not read, angles in several.
std::vector<Message> unread_units(const SampledTable& table, const ColumnNames& names);

}  // namespace remount::guesses
