// Captures of each make of LiDAR, of a few packets.
#pragma once

#include <vector>

#include "tests/model/formats/sample_inputs.h"

namespace remount::formats {

/// For the readers of captures, with what lies beside them.
std::vector<Sample> captured_samples();

}  // namespace remount::formats
