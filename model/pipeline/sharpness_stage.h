// The map check: how sharp the accumulated scans are under the nominal, the candidates and the result.
#pragma once

#include "model/pipeline.h"
#include "model/pipeline/register_stage.h"

namespace remount {

/// Over a few short stretches of the drive in which it turns most, for there X shows most. The result first, then the
/// nominal where there is one, then the best candidates in range. Scans that cannot be read are left out. Empty where
/// no stretch has scans that overlap.
std::vector<NamedSharpness> check_sharpness(const StageContext& context, const ScanStore& scans,
                                            const CalibrationResult& result,
                                            const std::optional<RigidTransform>& nominal_ins_from_lidar,
                                            Progress& progress);

/// A finding where the map is clearly sharper under the nominal than under the result.
void report_sharpness(const std::vector<NamedSharpness>& sharpness, std::vector<Finding>& findings);

}  // namespace remount
