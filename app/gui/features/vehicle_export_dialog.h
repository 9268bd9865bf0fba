// Exports of all LiDARs of a vehicle.
#pragma once

#include <QWidget>

#include "model/results/vehicle_file.h"

namespace remount::gui {

class Workbench;

/// Choose the format, the frame that all are in and the names of the frames, which are remembered; see, copy, save.
void export_vehicle_from(const Workbench& workbench, const results::VehicleFile& vehicle, QWidget& window);

}  // namespace remount::gui
