// The map check: how sharp the accumulated scans are under the nominal, the candidates and the result.
#pragma once

#include "model/pipeline.h"
#include "model/pipeline/register_stage.h"

namespace remount {

/// Over a few short stretches of the drive in which it turns most, for there X shows most. The result first, then the
/// nominal where there is one, then the best candidates in range. Scans that cannot be read are left out. Motion within
/// the scans is compensated as `scans` does it, under one X: what another X would make of it is not compared. Empty
/// where no stretch has scans that overlap.
std::vector<NamedSharpness> check_sharpness(const StageContext& context, const ScanStore& scans,
                                            const CalibrationResult& result,
                                            const std::optional<RigidTransform>& nominal_ins_from_lidar,
                                            Progress& progress);

/// Code of the finding that report_sharpness makes.
inline constexpr const char* kMapLessSharp = "map-less-sharp";

/// A finding where the map is clearly sharper under the nominal than under the result, over at least 200
/// neighbourhoods.
void report_sharpness(const std::vector<NamedSharpness>& sharpness, std::vector<Finding>& findings);

}  // namespace remount
