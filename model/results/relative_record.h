// Where one LiDAR of a vehicle sits against another, whichever of the two the file names first.
#pragma once

#include <optional>
#include <string_view>

#include "model/results/vehicle_file.h"

namespace remount::results {

/// `lidar_a_from_lidar_b` with its sigmas. Where the file has it the other way round, sigmas become those of any axis,
/// for turns move the place as well; nothing then where a parameter is not observed. Nothing where it has neither.
std::optional<RelativeRecord> relative_record(const VehicleFile& vehicle, std::string_view lidar_a,
                                              std::string_view lidar_b);

}  // namespace remount::results
