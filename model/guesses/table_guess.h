// What the motion of an INS is in one table.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "algorithms/core/progress.h"
#include "model/guesses/description.h"
#include "model/guesses/time_readings.h"

namespace remount::guesses {

/// Nothing where the table lacks something, of which `missing` then says what, or where that was cancelled.
/// @param stamps_ns of scans; may be empty
std::optional<InsGuess> guess_ins_of(const FoundTable& found, const std::vector<std::int64_t>& stamps_ns,
                                     const Progress& progress, std::vector<Message>& missing);

/// How many of the rows are read, and at which rate. @param left_out why the first that was not read was not; empty
/// where all were
Guess rows_guess(const SampledTable& table, const TimeReading& time, std::size_t samples, const Message& left_out);

/// As a session does where nothing names the week.
void place_in_week(InsGuess& ins, const std::vector<std::int64_t>& stamps_ns);

}  // namespace remount::guesses
