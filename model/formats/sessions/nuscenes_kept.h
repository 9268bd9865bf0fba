// Tables of nuScenes that were read before.
#pragma once

#include <chrono>
#include <memory>

#include "model/formats/sessions/nuscenes_tables.h"

namespace remount::formats {

/// As read_nuscenes_tables and read_ego_poses. Tables of hundreds of megabytes are read for a list of LiDARs, for a
/// choice of scenes and for each session: what was read last is kept and given again as long as their files have the
/// same size and time (files of the last two seconds are read anew), until two minutes after the last use. Safe from
/// several threads, of which one reads and the others wait, and can be cancelled.
std::shared_ptr<const NuscenesTables> kept_nuscenes_tables(const std::filesystem::path& tables, Progress& progress);
std::shared_ptr<const NuscenesPoses> kept_ego_poses(const std::shared_ptr<const NuscenesTables>& tables,
                                                    Progress& progress);

/// How long from now on. @return how long it was until now
std::chrono::milliseconds keep_nuscenes_for(std::chrono::milliseconds time);

/// How many tables were read from their files so far, those of sweeps and of poses each counted once.
std::size_t nuscenes_readings();

}  // namespace remount::formats
