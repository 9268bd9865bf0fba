// The results of several LiDARs of a vehicle as a file holds them.
#pragma once

#include <vector>

#include "algorithms/core/progress.h"
#include "model/results/vehicle_file.h"
#include "model/rig/rig_calibration.h"

namespace remount::project {

/// @param jobs of which `output` is @param inputs hashes of what each LiDAR's calibration read, in their order; may be
/// empty
results::VehicleFile make_vehicle_file(const std::vector<rig::LidarJob>& jobs, const rig::RigOutput& output,
                                       std::vector<std::vector<results::InputFile>> inputs);

/// Hashes of what each LiDAR's calibration read, in the order of the jobs; a file that several share is read once. A
/// file that cannot be read has no hash, which throws nothing. Where `progress` is cancelled those that were not read
/// yet have neither hash nor size: whoever keeps the list asks for that first.
std::vector<std::vector<results::InputFile>> hash_lidars(const std::vector<rig::LidarJob>& jobs, int threads,
                                                         Progress& progress);

}  // namespace remount::project
