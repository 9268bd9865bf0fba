// Phrases of the checks of recorded data (model/checks).
#pragma once

#include <vector>

namespace remount {

const std::vector<const char*>& check_phrases();

/// What each code of a finding means, and what to do about it.
const std::vector<const char*>& meaning_phrases();

}  // namespace remount
