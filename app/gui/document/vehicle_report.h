// The report of all LiDARs of a vehicle.
#pragma once

#include <QString>

#include "app/gui/workbench/workbench.h"

namespace remount::gui {

/// Writes a page of what the LiDARs that were calibrated together say, in the language of the window; the notices say
/// what became of it. Does nothing where there is no common solution.
void make_vehicle_report(Workbench& workbench, const QString& html_path);

}  // namespace remount::gui
