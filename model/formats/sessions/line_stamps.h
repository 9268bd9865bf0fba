// Files with the stamp of a scan in each line.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string_view>
#include <vector>

#include "model/drive/bad_items.h"

namespace remount::formats {

/// Line i is for scan i: an empty or unreadable one has no stamp, and the last one has. Throws Error(Io).
/// @param parse of a line without blanks around it, ns @param expected of a line, for people @param bad takes those
/// that are neither empty nor readable
std::vector<std::optional<std::int64_t>> read_line_stamps(const std::filesystem::path& path,
                                                          std::optional<std::int64_t> (*parse)(std::string_view text),
                                                          const Message& expected, drive::BadItems& bad);

}  // namespace remount::formats
