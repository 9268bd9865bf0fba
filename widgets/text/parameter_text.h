// Names, units and numbers of the six parameters of X, the same in every panel and table.
#pragma once

#include <QString>

#include "model/results/display_units.h"

namespace remount::widgets {

/// So many decimals, and no sign before what rounds to zero.
QString rounded_text(double value, int decimals);
/// "± 0.0012"; "± < 0.0001" where it rounds to nothing, which no sigma is.
QString spread_text(double spread, int decimals);
/// "x", "yaw", in the language of the window.
QString parameter_name(calibration::Parameter parameter);
/// "x, yaw"; empty for none.
QString shown_parameter_names(calibration::ParameterSet given);
/// " m" or "°", to follow a number.
QString unit_suffix(calibration::Parameter parameter);
/// "+1.24 mm", "-0.0031°", "+2.400°": how far a parameter moved, given in m or degrees.
QString moved_text(calibration::Parameter parameter, double change);

}  // namespace remount::widgets
