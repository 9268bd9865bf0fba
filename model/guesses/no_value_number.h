// Numbers that loggers write where a value was not known.
#pragma once

#include "model/guesses/sampled_table.h"

namespace remount::guesses {

/// Finds a number of nines (-9999) that lies far outside what a column else holds; in all columns it is none then, and
/// the text of the table says so.
void find_no_value(SampledTable& table);

}  // namespace remount::guesses
