// What the calibration methods say: parts of model_phrases().
#pragma once

#include <vector>

namespace remount {

/// Methods, what they need, refuse, find and advise; comparisons of results.
const std::vector<const char*>& method_phrases();

/// Names and help of the options that single methods have.
const std::vector<const char*>& method_option_phrases();

}  // namespace remount
