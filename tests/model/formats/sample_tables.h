// Tables that no format is known of, and the scans beside them.
#pragma once

#include <string>

namespace remount::formats::samples {

/// Commas of decimals, and scans with a table of their times: a pack of files without a manifest.
std::string undeclared_table();

/// The same with its manifest. @param metric positions are metres
std::string declared_table(bool metric);

/// Times in columns of year to second, rows without a value, and scans with dates in their names.
/// @param declared with its manifest
std::string table_of_parts(bool declared);

}  // namespace remount::formats::samples
