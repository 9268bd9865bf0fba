// The scans of a native session: which files, and when each was taken.
#pragma once

#include <filesystem>
#include <optional>
#include <string_view>
#include <vector>

#include "algorithms/core/progress.h"
#include "model/drive/stamped_streams.h"
#include "model/formats/clouds/cloud_file.h"
#include "model/formats/files/declared_table.h"

namespace remount::formats {

/// Of files whose names are stamps ("1317384506400000000" ns, "1317384506.4" s) or hold a date (date_in_name_ns),
/// ascending. Other names become a finding.
std::vector<drive::ScanFile> scans_from_names(const std::vector<std::filesystem::path>& files,
                                              const std::filesystem::path& directory, CloudFormat format,
                                              std::vector<drive::Finding>& findings);

/// How times stand in names that are not those alone.
struct NameTimes {
  std::int64_t unit_ns = 1'000'000'000;  ///< 0: dates
  TimeScale scale = TimeScale::Unix;
  std::int64_t offset_ns = 0;  ///< added to them
};
/// Of files with a time in their names (time_in_name_ns); likewise.
std::vector<drive::ScanFile> scans_from_names(const std::vector<std::filesystem::path>& files,
                                              const std::filesystem::path& directory, CloudFormat format,
                                              const NameTimes& times, std::vector<drive::Finding>& findings);

/// Of files whose points carry dates (ReadCloud::first_point_ns): each is read once. Those that cannot be read or have
/// none become a finding. Throws Error(Format) with the reason of the first where that is all of them.
std::vector<drive::ScanFile> scans_from_points(const std::vector<std::filesystem::path>& files,
                                               const std::filesystem::path& directory, CloudFormat format,
                                               std::vector<drive::Finding>& findings, Progress& progress);

/// The files of a format, those with numbers in their names in the order of these: 2.pcd before 10.pcd.
std::vector<std::filesystem::path> scans_in_order(const std::vector<std::filesystem::path>& files, CloudFormat format);

/// A table of somebody's with the times of scans.
struct ScanTimes {
  std::filesystem::path table;
  TableText text;
  TimeColumns time;
  std::optional<ColumnRef> scan;  ///< names the file, with its extension or without; none: a row each, in their order
};
/// Throws Error(Format) where a column is missing, or, without the names of scans, there are more or fewer rows.
std::vector<drive::ScanFile> scans_from_times(std::string_view text, const ScanTimes& times,
                                              const std::vector<std::filesystem::path>& files,
                                              const std::filesystem::path& directory, CloudFormat format,
                                              std::vector<drive::Finding>& findings);

/// Of the text of a table with columns `file` and `stamp_ns`; what is missing becomes a finding. Throws Error(Format)
/// where a column is.
std::vector<drive::ScanFile> scans_from_table(std::string_view text, const std::filesystem::path& table,
                                              const std::filesystem::path& directory,
                                              std::vector<drive::Finding>& findings);

}  // namespace remount::formats
