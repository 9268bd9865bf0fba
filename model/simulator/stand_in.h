// The LiDAR of a drive, or another one that stands in its place.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "model/simulator/lidar_model.h"
#include "model/simulator/simulator.h"

namespace remount::simulator {

/// The scans of the drive's LiDAR where that is one of these models, else of the first of them in its place; with the
/// points of its data sheet, and their times. Throws Error(Contract) for a drive that is not simulated, or without
/// motion distortion. @param format for messages
SimulatedScanSource scans_of_model(const SimulatedDrive& drive, std::span<const std::string_view> models,
                                   const std::string& format);

}  // namespace remount::simulator
