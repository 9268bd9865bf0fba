// The scans of a native session: which files, and when each was taken.
#pragma once

#include <filesystem>
#include <string_view>
#include <vector>

#include "model/drive/stamped_streams.h"
#include "model/formats/clouds/cloud_file.h"

namespace remount::formats {

/// Of files whose names are stamps ("1317384506400000000" ns, "1317384506.4" s, or a date), ascending. Other names
/// become a finding.
std::vector<drive::ScanFile> scans_from_names(const std::vector<std::filesystem::path>& files,
                                              const std::filesystem::path& directory, CloudFormat format,
                                              std::vector<drive::Finding>& findings);

/// Of the text of a table with columns `file` and `stamp_ns`; what is missing becomes a finding. Throws Error(Format)
/// where a column is.
std::vector<drive::ScanFile> scans_from_table(std::string_view text, const std::filesystem::path& table,
                                              const std::filesystem::path& directory,
                                              std::vector<drive::Finding>& findings);

}  // namespace remount::formats
