// What scans there are, and when each was taken.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "algorithms/core/progress.h"
#include "model/formats/clouds/scan_list.h"
#include "model/guesses/found_files.h"
#include "model/guesses/found_tables.h"
#include "model/guesses/guess.h"

namespace remount::guesses {

struct ScansGuess {
  std::string name;                 ///< of the LiDAR, where there are several
  std::filesystem::path directory;  ///< or the file of a capture or of poses
  bool capture = false;
  std::optional<std::string> pose_format;  ///< of a file of LiDAR poses
  formats::CloudFormat format = formats::CloudFormat::Pcd;
  std::size_t count = 0;
  std::optional<formats::NameTimes> in_names;   ///< else names are times as they are, where nothing of these is set
  bool in_points = false;                       ///< the points have dates
  std::optional<formats::ScanTimes> table;      ///< somebody's
  std::optional<std::filesystem::path> stamps;  ///< a table as a native session has it
  bool by_numbers = false;                      ///< names are numbers that may be times of whatever clock
  bool timed = false;                           ///< when they were taken is known
  bool per_point = false;
  std::vector<std::int64_t> stamps_ns;  ///< ascending
  std::vector<Guess> guesses;
};

/// "pcd", "kitti-bin": as a manifest has it.
std::string type_name(formats::CloudFormat format);

double median_step_s(const std::vector<std::int64_t>& stamps_ns);

/// Whether the names are numbers that go up by one, as those of files do.
bool names_count(const CloudFolder& folder);

/// Reads every scan where only their points tell when they were taken.
/// @param tables that were found anywhere
ScansGuess guess_scans(const CloudFolder& folder, const std::vector<FoundTable>& tables, Progress& progress);

}  // namespace remount::guesses
