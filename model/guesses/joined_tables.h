// What the motion of an INS is in two tables, one with its positions and one with its attitudes.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "algorithms/core/progress.h"
#include "model/guesses/description.h"

namespace remount::guesses {

/// Of tables with these parts (motion_parts.h). What they mean together is compared with the direction of travel, as of
/// one table. Nothing where they do not go together, of which `missing` then says why, or where that was cancelled.
/// @param stamps_ns of scans; may be empty
std::optional<InsGuess> guess_ins_of_two(const FoundTable& positions, const FoundTable& attitudes,
                                         const std::vector<std::int64_t>& stamps_ns, const Progress& progress,
                                         std::vector<Message>& missing);

}  // namespace remount::guesses
