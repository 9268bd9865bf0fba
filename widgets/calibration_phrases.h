// What calibrations say of their data, pairs and results: a part of model_phrases().
#pragma once

#include <vector>

namespace remount {

const std::vector<const char*>& calibration_phrases();

}  // namespace remount
