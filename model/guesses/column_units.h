// Units that stand in the titles of a table, beside those in which its columns are read.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "model/guesses/table_choices.h"

namespace remount::guesses {

/// Reads a column as its title says: in radians, in milliseconds; a text as a date. Others of its kind go with it, for
/// a manifest has one unit for them. Nothing where its role has no unit, or the title says none that can be read.
void take_stated_unit(const SampledTable& table, std::size_t column, TableChoices& choices);

/// A column of which the title states another unit than that in which it is read.
struct OtherUnit {
  std::size_t column = 0;
  ColumnRole role = ColumnRole::Ignored;
  std::string stated, read;
};
std::vector<OtherUnit> other_units(const SampledTable& table, const TableChoices& choices);

}  // namespace remount::guesses
