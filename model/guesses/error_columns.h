// The columns that tell how sure an INS is.
#pragma once

#include "model/guesses/motion_guess.h"

namespace remount::guesses {

/// Adds the sigmas of position and attitude and the quality that the names of columns tell, as far as a manifest has
/// room for them, to the layout and to what was chosen.
void put_errors(const SampledTable& table, const ColumnNames& names, ChosenMotion& chosen);

}  // namespace remount::guesses
