// The tables of nuScenes, as far as LiDARs are concerned.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "algorithms/core/progress.h"
#include "algorithms/geometry/rigid_transform.h"
#include "algorithms/motion/ins_sample.h"
#include "model/drive/finding.h"

namespace remount::formats {

/// A turn of a LiDAR.
struct NuscenesSweep {
  std::int64_t stamp_ns = 0;
  std::filesystem::path file;  ///< relative to the folder of the data set
  std::string ego_pose;        ///< token
  std::size_t channel = 0;     ///< of NuscenesTables::channels
  RigidTransform ego_from_lidar;
};

struct NuscenesScene {
  std::string name;
  std::vector<NuscenesSweep> sweeps;  ///< of all LiDARs, as the table has them
};

struct NuscenesTables {
  std::vector<std::string> channels;  ///< of LiDARs, by name: "LIDAR_TOP"
  std::vector<NuscenesScene> scenes;  ///< that have sweeps, by name
};

/// The folders of tables (`v1.0-mini`, …) of a data set, by name; empty where it is none.
std::vector<std::filesystem::path> nuscenes_tables_in(const std::filesystem::path& root);

/// All sweeps of LiDARs by their scenes. Takes memory for these alone, a fraction of the tables. Throws Error naming
/// file and byte where a table is missing or broken. Empty where it is cancelled.
NuscenesTables read_nuscenes_tables(const std::filesystem::path& tables, Progress& progress);

/// Of the sweeps' ego poses, global_from_ego, by their own stamps in the order of the sweeps; poses that are not there
/// become a finding. Throws Error(Format) where none is. Empty where it is cancelled.
std::vector<motion::StampedPose> read_ego_poses(const std::filesystem::path& tables,
                                                const std::vector<NuscenesSweep>& sweeps,
                                                std::vector<drive::Finding>& findings, Progress& progress);

}  // namespace remount::formats
