// Whether the clocks of LiDAR and INS go together.
#pragma once

#include <optional>
#include <vector>

#include "model/guesses/description.h"

namespace remount::guesses {

/// How many of the stamps lie between samples of the INS, gaps left out. @param added_ns to the times of the INS
std::size_t count_within(const InsGuess& ins, const std::vector<std::int64_t>& stamps_ns, std::int64_t added_ns = 0);

/// How many scans lie within the motion of the INS; where few do, how far apart the clocks are, and which of the usual
/// differences (leap seconds, time zones, epochs, weeks) would bring them together. Nothing where no scan has a time.
std::optional<Guess> guess_clock(const InsGuess& ins, const std::vector<ScansGuess>& lidars);

}  // namespace remount::guesses
