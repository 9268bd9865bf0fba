// The methods that are built in, one file each.
#pragma once

#include "model/methods/calibration_method.h"

namespace remount {}  // namespace remount
