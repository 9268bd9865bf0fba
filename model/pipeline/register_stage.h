// Objects, shared objects and registration of every pair.
#pragma once

#include <vector>

#include "algorithms/core/progress.h"
#include "algorithms/registration/registration.h"
#include "model/pipeline/scan_store.h"
#include "model/pipeline/shared_field.h"
#include "model/settings/settings.h"

namespace remount::pipeline {

/// What is kept of a keyframe's objects: without their points.
struct KeyframeObjects {
  std::vector<cloud::SceneObject> objects;
  std::vector<bool> moving;  ///< seen to move in some pair
  Message failure;           ///< why the scan could not be read; empty where it could
  bool looked_for = false;
};

struct StageContext {
  const DriveMotion& motion;
  const settings::Settings& settings;
  const std::vector<motion::Keyframe>& keyframes;
  RigidTransform ins_from_lidar = RigidTransform::Identity();  ///< initial X: nominal or coarse
  int threads = 0;
  const SharedField* field = nullptr;  ///< of the sessions; nothing: all of it is common to any two scans
};

/// Direction away from the ground in the lidar frame of a scan: what the INS calls up, carried through X.
Eigen::Vector3f up_in_lidar(const StageContext& context, const motion::Keyframe& keyframe);

/// Objects of each keyframe that some pair uses and that were not looked for yet. A scan that cannot be read is named
/// and its objects stay empty. @param objects of each keyframe, or empty before the first call
void find_keyframe_objects(const StageContext& context, const ScanStore& scans, const std::vector<motion::Pair>& pairs,
                           std::vector<KeyframeObjects>& objects, Progress& progress);

/// Counts shared and moving objects of each pair; rejects those that share too few, with the reason.
void match_pairs(const StageContext& context, std::vector<KeyframeObjects>& objects, std::vector<motion::Pair>& pairs,
                 Progress& progress);

/// Registers every pair that is not rejected, from the motion that INS and X predict; rejects failures with the reason.
void register_pairs(const StageContext& context, ScanStore& scans, const std::vector<KeyframeObjects>& objects,
                    std::vector<motion::Pair>& pairs, Progress& progress);

/// Q of a pair, its information and quality from the clouds at a motion.
void take_equations(const registration::AlignmentEquations& equations, const RigidTransform& lidar_b_from_lidar_a,
                    motion::Pair& pair);

/// Q and its information from the clouds at the motion that the joint solution predicts, instead of each pair's own
/// minimum: a direction that a pair does not show stays at the prediction. For the joint alignment of all clouds.
void relinearise_pairs(const StageContext& context, ScanStore& scans, const std::vector<KeyframeObjects>& objects,
                       const std::vector<RigidTransform>& predicted_lidar_b_from_lidar_a,
                       std::vector<motion::Pair>& pairs, Progress& progress);

}  // namespace remount::pipeline
