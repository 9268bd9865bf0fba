// A first X for an unknown mounting.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "algorithms/core/progress.h"
#include "model/pipeline/scan_store.h"
#include "model/pipeline/suspect_stage.h"
#include "model/settings/settings.h"

namespace remount::pipeline {

struct CoarseStart {
  std::optional<RigidTransform> ins_from_lidar;  ///< nothing where the drive does not show it
  std::optional<Eigen::Vector3d> up_in_lidar;    ///< away from the ground, unit length; nothing where none was seen
  int registrations = 0;
  int failures = 0;
  std::size_t readable = 0, unreadable = 0;  ///< scans that were tried
  Message first_unreadable;
  Message problem;                   ///< why there is none
  std::vector<FarClock> far_clocks;  ///< as the chained scans have it
};

/// Registers neighbouring scans, which lie so close that no start value is needed, chains them to a lidar trajectory
/// and solves P X = X Q over longer stretches of it. Works for any orientation of the sensor.
CoarseStart find_coarse_start(const DriveMotion& motion, const settings::Settings& settings, int threads,
                              Progress& progress);

}  // namespace remount::pipeline
