// Names of scans that are numbers of a clock without a date: that of the INS tells whether they are times, and of what.
#pragma once

#include "model/guesses/description.h"

namespace remount::guesses {

/// Where nothing but numbers in the names may tell when scans were taken: their times, in the unit and on the clock
/// (that of the INS, seconds of its week or of its day) in which they lie within its motion. What else fits as well is
/// an alternative.
void take_clock_of_ins(const CloudFolder& folder, const InsGuess& ins, ScansGuess& scans);

}  // namespace remount::guesses
