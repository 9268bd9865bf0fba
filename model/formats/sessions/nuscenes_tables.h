// The tables of nuScenes, as far as LiDARs are concerned.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <unordered_map>
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
  RigidTransform ego_from_lidar = RigidTransform::Identity();
};

struct NuscenesScene {
  std::string name;
  std::vector<NuscenesSweep> sweeps;  ///< of all LiDARs, as the table has them
};

struct NuscenesTables {
  std::filesystem::path folder;
  std::vector<std::string> channels;     ///< of LiDARs, by name: "LIDAR_TOP"
  std::vector<NuscenesScene> scenes;     ///< that have sweeps, by name
  std::vector<drive::Finding> findings;  ///< rows that cannot be used
};

/// Of the sweeps of all scenes.
struct NuscenesPoses {
  std::unordered_map<std::string, motion::StampedPose> global_from_ego;  ///< by token
  std::unordered_map<std::string, Message> broken;                       ///< what is wrong with a pose, by token
  std::vector<drive::Finding> findings;                                  ///< rows that say not even of what they are
};

inline constexpr const char* kNuscenesTables[] = {"sensor", "calibrated_sensor", "scene",
                                                  "sample", "sample_data",       "ego_pose"};

/// The folders of tables (`v1.0-mini`, …) of a data set, by name; empty where it is none.
std::vector<std::filesystem::path> nuscenes_tables_in(const std::filesystem::path& root);
/// Whether a folder is one of these.
bool are_nuscenes_tables(const std::filesystem::path& folder);

/// All sweeps of LiDARs by their scenes. Takes memory for these alone, a fraction of the tables. Rows that cannot be
/// used are left out and told. Throws Error naming file and row where a table is missing or none, or nothing is left.
/// Null where it is cancelled.
std::shared_ptr<const NuscenesTables> read_nuscenes_tables(const std::filesystem::path& tables, Progress& progress);

/// The ego poses, global_from_ego, of all these sweeps, by their own stamps. Throws Error(Format) where the table is
/// none. Null where it is cancelled.
std::shared_ptr<const NuscenesPoses> read_ego_poses(const NuscenesTables& tables, Progress& progress);

/// Of these sweeps, in their order. A pose that is broken or not there becomes a finding. Throws Error(Format) where
/// none is there.
std::vector<motion::StampedPose> poses_of_sweeps(const NuscenesPoses& poses, const std::vector<NuscenesSweep>& sweeps,
                                                 const std::filesystem::path& table,
                                                 std::vector<drive::Finding>& findings);

}  // namespace remount::formats
