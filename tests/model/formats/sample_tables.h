// Tables that no format is known of, with and without a manifest, and the scans beside them.
#pragma once

#include <vector>

#include "tests/model/formats/sample_inputs.h"

namespace remount::formats {

/// For those who describe tables, and the readers of manifests.
std::vector<Sample> table_samples();

}  // namespace remount::formats
