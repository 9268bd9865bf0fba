// How many fields the rows of a table may have.
#pragma once

#include <functional>
#include <string_view>
#include <vector>

#include "model/formats/files/input_file.h"

namespace remount::formats {

/// Parts a line into its fields.
using SplitLine = std::function<void(std::string_view line, std::vector<std::string_view>& fields)>;

/// The most filled fields (filled_fields) that a row may have. In a row with more of them something has parted a field
/// and moved those behind it, as a comma for the point of decimals does. Without names as many as most of the first
/// rows have. With names as many as these, or one more where most of the first rows have a last one without a name; two
/// more in most rows are no columns either, for such commas part every number.
/// @param lines before the first row; empty ones and those that begin with '#' are none
/// @param names how many columns have one; 0: the table has no names
std::size_t most_fields(LineReader lines, std::size_t names, const SplitLine& split);

}  // namespace remount::formats
