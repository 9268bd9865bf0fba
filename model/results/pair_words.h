// What became of many pairs, in few words: for the command line, where nobody looks at them one by one.
#pragma once

#include <vector>

#include "model/results/result_file.h"

namespace remount::results {

/// "the shift along the street", "the height", "roll": what the scans of an accepted pair do not show, by its reason
/// ("does not determine the shift along [0.96, -0.28, -0.01] (axes of the lidar)"), in axes of the INS where X is
/// usable and these are known; "every direction of motion" where they are not, and of a reason that an older file holds
/// as mere words. Empty where the reason says nothing of the kind.
Message not_shown_by(const Message& reason, const ResultFile& file);

/// One line for each kind of reason, with the number of its pairs: accepted ones whose scans leave something open, then
/// rejected ones, both from the most to the fewest. At most `most_kinds` of rejections; the rest are counted together.
std::vector<Message> pair_lines(const ResultFile& file, std::size_t most_kinds = 4);

}  // namespace remount::results
