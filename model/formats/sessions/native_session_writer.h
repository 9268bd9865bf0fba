// Writing sessions to disk: Remount's own folder and KITTI raw.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "algorithms/core/progress.h"
#include "model/drive/session.h"
#include "model/formats/clouds/cloud_file.h"

namespace remount::formats {

/// Writes session.yaml, scans/*.pcd (binary, with intensity, ring and time where the scans have them) or
/// lidar_poses.txt, ins.csv or ins_poses.txt, and a table of each other sensor. Reads back to the same stamps, to 1e-12
/// degrees and 1e-9 m; points to float. Poses of the INS that are far from their origin, as on a grid, are moved near
/// it. Scans are loaded one by one on `threads` workers (0: one per core); the bytes do not depend on their number. The
/// folder is made. Throws Error(Contract) where the session has no INS or no LiDAR motion and no other sensor either,
/// Error(Io) where writing fails; returns early where `progress` is cancelled, without session.yaml.
/// @param scans Pcd, Text (scans/*.csv) or Las: scans/*.las holds no rings, points to 0.1 mm
void write_native_session(const drive::Session& session, const std::filesystem::path& folder, int threads,
                          Progress& progress, CloudFormat scans = CloudFormat::Pcd);

/// A recording of several LiDARs, a session for each with its `lidar_name`, as one folder that declares them under
/// `lidars`: NAME/scans and NAME/scan_stamps.csv of each, or NAME/lidar_poses.txt. The INS and all other sensors are
/// those of the first. Throws Error(Contract) as well where names are none or stand twice.
void write_native_session(const std::vector<const drive::Session*>& lidars, const std::filesystem::path& folder,
                          int threads, Progress& progress, CloudFormat scans = CloudFormat::Pcd);

/// Poses as lines of `t x y z qx qy qz qw`, t in seconds.
std::string tum_text(const std::vector<motion::StampedPose>& poses);

/// Writes `<folder>/<date>/<date>_drive_0001_sync` where INS and scans have equal stamps, `_extract` with the INS's own
/// stamps otherwise. Needs geodetic INS samples and scans: throws Error(Contract) else. KITTI has no place for rings,
/// per-point times, INS noise other than the position's, and the other sensors.
void write_kitti_raw_session(const drive::Session& session, const std::filesystem::path& folder, int threads,
                             Progress& progress);

}  // namespace remount::formats
