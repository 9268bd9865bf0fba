// The map check: how sharp the accumulated scans are under the nominal, the candidates and the result.
#pragma once

#include "model/pipeline/pipeline.h"
#include "model/pipeline/register_stage.h"

namespace remount::pipeline {

/// Over a few short stretches of the drive in which it turns most, for there X shows most. The result first, then the
/// nominal where there is one, then the best candidates in range. Scans that cannot be read are left out. Motion within
/// the scans is compensated as `scans` does it, under one X: what another X would make of it is not compared. Empty
/// where no stretch has scans that overlap.
std::vector<quality::NamedSharpness> check_sharpness(const StageContext& context, const ScanStore& scans,
                                                     const calibration::CalibrationResult& result,
                                                     const std::optional<RigidTransform>& nominal_ins_from_lidar,
                                                     Progress& progress);

/// check_sharpness of the output's X, into `sharpness` and `map_check`, unless the settings switch it off.
void take_sharpness(const StageContext& context, const ScanStore& scans,
                    const std::optional<RigidTransform>& nominal_ins_from_lidar, PipelineOutput& output,
                    Progress& progress);

/// For an X that has moved: the map check was the former X's, and so was what it said.
void forget_sharpness(PipelineOutput& output);

/// Code of the finding that report_sharpness makes.
inline constexpr const char* kMapLessSharp = "map-less-sharp";

/// A finding where the map is clearly sharper under the nominal than under the result.
void report_sharpness(const std::vector<quality::NamedSharpness>& sharpness, std::vector<drive::Finding>& findings);

}  // namespace remount::pipeline
