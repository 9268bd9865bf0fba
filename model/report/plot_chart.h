// The plots of a method as drawings.
#pragma once

#include "algorithms/calibration/method_details.h"
#include "model/report/charts.h"

namespace remount::report {

/// Axes with ticks and labels, every curve in a colour of its own with its name, three sigma as thin lines beside it.
/// What is not finite is left out and interrupts a line.
Drawing plot_chart(const calibration::Plot& plot, Language language);

/// "#rrggbb" of the curve at that place of a plot.
const char* curve_color(std::size_t curve);

/// A quantity for people: "1.0042 ± 0.0003", angles in degrees, "not observed" where it is not.
std::string quantity_text(const calibration::NamedQuantity& quantity, Language language);

}  // namespace remount::report
