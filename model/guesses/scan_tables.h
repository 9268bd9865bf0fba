// Tables that tell when scans were taken: as a native session has them, or as somebody wrote them.
#pragma once

#include <cstdint>
#include <vector>

#include "model/drive/session.h"
#include "model/guesses/scans_guess.h"

namespace remount::guesses {

/// In their order, without those that are no time of this century.
std::vector<std::int64_t> ascending_stamps(const std::vector<drive::ScanFile>& scans);

/// A table with the columns `file` and `stamp_ns`, of files that are in the folder. False where there is none.
bool take_native_table(const CloudFolder& folder, const std::vector<FoundTable>& tables, ScansGuess& scans);

/// A table with a row for each scan, that names it or stands in the order of the names. A column names scans where
/// nearly every row has one of its own. False where there is none.
bool take_table(const CloudFolder& folder, const std::vector<FoundTable>& tables, ScansGuess& scans);

}  // namespace remount::guesses
