// Names and units of the six parameters of X, the same in every panel and table.
#pragma once

#include <QString>

#include "model/display_units.h"

namespace remount {

/// "x", "yaw": of parameter i in the order of kParameterNames.
QString parameter_name(std::size_t i);
/// " m" or "°", to follow a number.
QString unit_suffix(std::size_t i);

}  // namespace remount
