// The last line of a table that was cut while it was written.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "model/drive/finding.h"

namespace remount::formats {

/// The text of a table without its last line where that was cut: it lacks its end, and has fewer fields than the lines
/// before it, or a last number with fewer digits than theirs, by so many that it is another. Becomes a finding
/// "log-cut".
std::string_view without_cut_line(std::string_view text, const std::string& path,
                                  std::vector<drive::Finding>& findings);

}  // namespace remount::formats
