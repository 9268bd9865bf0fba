// What the scene of a pair is made of, prepared before it is shown: on any thread, immutable afterwards.
#pragma once

#include <memory>
#include <set>
#include <vector>

#include "algorithms/core/progress.h"
#include "algorithms/geometry/rigid_transform.h"
#include "model/pipeline/pair_clouds.h"

namespace remount::scene {

/// Under which transform the source scan is shown.
enum class PairAlignment {
  Before,      ///< predicted from INS motion and the mounting that the calibration started from
  Registered,  ///< as the two scans were aligned
  CurrentX,    ///< predicted from INS motion and the present result, or a candidate
};

/// The three ways to bring scan a to scan b, and the axes in which the scene is shown.
struct PairTransforms {
  RigidTransform before_lidar_b_from_lidar_a = RigidTransform::Identity();
  RigidTransform registered_lidar_b_from_lidar_a = RigidTransform::Identity();
  RigidTransform current_lidar_b_from_lidar_a = RigidTransform::Identity();
  bool current_known = true;  ///< there is a result, or a candidate is looked at
  /// Brings lidar b to the axes of the vehicle, so that "top" is above the vehicle however the sensor is turned.
  RigidTransform view_from_lidar_b = RigidTransform::Identity();
  Eigen::Vector3d up_in_view = Eigen::Vector3d::UnitZ();  ///< away from the ground

  const RigidTransform& of(PairAlignment alignment) const;
};

/// Predictions X^-1 P X under the starting and the present mounting, and the registration of pair `pair`.
/// @param candidate_ins_from_lidar an X to look at instead of the present result
PairTransforms pair_transforms(const pipeline::PipelineOutput& output, motion::PairIndex pair,
                               const RigidTransform* candidate_ins_from_lidar = nullptr);
/// Of a pair of two LiDARs: before, as each had it alone; after, as all together have it.
PairTransforms cross_pair_transforms(const motion::Pair& pair, const pipeline::PipelineOutput& of_a,
                                     const pipeline::PipelineOutput& of_b, const pipeline::PipelineOutput& alone_a,
                                     const pipeline::PipelineOutput& alone_b);

/// On the way from one transform to another: 0 is the first, 1 the second; the rotation turns evenly.
RigidTransform between(const RigidTransform& first, const RigidTransform& second, double share);

struct PairSceneData;  // VTK inside: pair_scene_parts.h
using PairSceneDataPtr = std::shared_ptr<const PairSceneData>;

/// What scenes of pairs with a scan in common share of it; thread-safe. VTK inside: scan_scene.h
class ScanScenes;
std::shared_ptr<ScanScenes> make_scan_scenes();
/// Whether the ground is told apart while scans are prepared: scenes hide it.
void tell_ground_apart(ScanScenes& scans, bool on);

/// Points in the order of their levels, and boxes. Null where cancelled.
PairSceneDataPtr prepare_pair_scene(std::shared_ptr<const pipeline::PairClouds> clouds, ScanScenes& scans,
                                    const Progress& progress);
/// Of a pair that shares its scans with no other.
PairSceneDataPtr prepare_pair_scene(std::shared_ptr<const pipeline::PairClouds> clouds, const Progress& progress);

/// The scans that a scene was prepared from.
std::shared_ptr<const pipeline::PairClouds> clouds_of(const PairSceneData& data);

/// Adds up what scenes take, a scan that several share once.
class SceneMemory {
 public:
  /// About the bytes of all scenes that were added, this one included.
  std::size_t add(const PairSceneData& data);

 private:
  std::set<const void*> counted_;
  std::size_t bytes_ = 0;
};

/// How far each point of scan a is from the surfaces of scan b under this transform, m, negative behind them, in the
/// order in which the scene draws them; NaN for nothing near. Empty where cancelled.
std::vector<float> distances_to_target(const PairSceneData& data, const RigidTransform& lidar_b_from_lidar_a,
                                       const Progress& progress);

}  // namespace remount::scene
