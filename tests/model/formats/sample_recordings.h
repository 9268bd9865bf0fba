// Captures of Livox's and RoboSense's sensors, of a few packets, and recordings of Livox Viewer.
#pragma once

#include <vector>

#include "tests/model/formats/sample_inputs.h"

namespace remount::formats {

/// For the readers of captures.
std::vector<Sample> recorded_samples();

}  // namespace remount::formats
