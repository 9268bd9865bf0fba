// Captures of Livox's and RoboSense's sensors, of a few packets, recordings of Livox Viewer, and records of Apollo.
#pragma once

#include <vector>

#include "tests/model/formats/sample_inputs.h"

namespace remount::formats {

/// For the readers of captures and records.
std::vector<Sample> recorded_samples();

}  // namespace remount::formats
