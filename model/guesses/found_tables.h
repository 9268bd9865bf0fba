// Tables among files that nobody declared.
#pragma once

#include <cstddef>
#include <filesystem>
#include <vector>

#include "algorithms/core/progress.h"
#include "model/guesses/found_files.h"
#include "model/guesses/sampled_table.h"

namespace remount::guesses {

/// A table that was found, as far as one can read it.
struct FoundTable {
  std::filesystem::path file;
  SampledTable table;
};

/// Time, three of a position and two angles at least.
inline constexpr std::size_t kFewestColumnsOfMotion = 6;

/// Logs are few: what comes in hundreds with others of its kind beside it (labels, images) goes behind them.
void put_rare_kinds_first(std::vector<std::filesystem::path>& files);

/// Those that may hold a motion, or the times of the scans of a folder, in the order of the files; within bounds of
/// their number and memory. @param not_used to which is added what was read and is neither, and what was not read
std::vector<FoundTable> find_tables(const std::vector<std::filesystem::path>& files,
                                    const std::vector<CloudFolder>& clouds, const Progress& progress,
                                    std::vector<NotUsed>& not_used);

}  // namespace remount::guesses
