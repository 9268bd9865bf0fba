// Names and units of the six parameters of X, the same in every panel and table.
#pragma once

#include <QString>
#include <array>

#include "model/results/display_units.h"

namespace remount {

/// "x", "yaw", in the language of the window: of parameter i in the order of kParameterNames.
QString parameter_name(std::size_t i);
/// "x, yaw": of those that are, or are not; empty for none.
QString shown_parameter_names(const std::array<bool, 6>& given, bool wanted);
/// " m" or "°", to follow a number.
QString unit_suffix(std::size_t i);
/// "+1.24 mm", "-0.0031°", "+2.400°": how far parameter i moved, given in m or degrees.
QString moved_text(std::size_t i, double change);

}  // namespace remount
