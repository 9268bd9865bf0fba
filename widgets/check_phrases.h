// Phrases of the checks of recorded data (model/checks).
#pragma once

#include <vector>

namespace remount {

const std::vector<const char*>& check_phrases();

}  // namespace remount
