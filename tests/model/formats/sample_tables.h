// Tables that no format is known of, and the scans beside them.
#pragma once

#include <string>

namespace remount::formats::samples {

/// Commas of decimals, and scans with a table of their times: a pack of files without a manifest.
std::string undeclared_table();

/// The same with its manifest. @param metric positions are metres
std::string declared_table(bool metric);

}  // namespace remount::formats::samples
