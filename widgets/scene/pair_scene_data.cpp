#include "widgets/scene/pair_scene_data.h"

#include <Eigen/Geometry>

#include "model/results/result_words.h"
#include "widgets/scene/pair_colors.h"
#include "widgets/scene/pair_scene_parts.h"
#include "widgets/scene/scene_polydata.h"

namespace remount::scene {

const RigidTransform& PairTransforms::of(PairAlignment alignment) const {
  if (alignment == PairAlignment::Before) return before_lidar_b_from_lidar_a;
  if (alignment == PairAlignment::CurrentX) return current_lidar_b_from_lidar_a;
  return registered_lidar_b_from_lidar_a;
}

PairTransforms pair_transforms(const pipeline::PipelineOutput& output, motion::PairIndex pair,
                               const RigidTransform* candidate_ins_from_lidar) {
  const motion::Pair& chosen = output.pairs.at(pair);
  const RigidTransform& initial = output.initial_ins_from_lidar;
  const bool solved = results::has_mounting(output.result);
  const RigidTransform& result = solved ? output.result.mounting.ins_from_lidar() : initial;
  const RigidTransform& current = candidate_ins_from_lidar ? *candidate_ins_from_lidar : result;
  PairTransforms transforms;
  transforms.current_known = solved || candidate_ins_from_lidar;
  transforms.before_lidar_b_from_lidar_a = initial.inverse() * chosen.ins_b_from_ins_a * initial;
  transforms.current_lidar_b_from_lidar_a = current.inverse() * chosen.ins_b_from_ins_a * current;
  transforms.registered_lidar_b_from_lidar_a =
      chosen.registration.attempted ? chosen.lidar_b_from_lidar_a : transforms.before_lidar_b_from_lidar_a;
  transforms.view_from_lidar_b = result;  // not the candidate: the view stays while candidates are compared
  return transforms;
}

PairTransforms cross_pair_transforms(const motion::Pair& pair, const pipeline::PipelineOutput& of_a,
                                     const pipeline::PipelineOutput& of_b, const pipeline::PipelineOutput& alone_a,
                                     const pipeline::PipelineOutput& alone_b) {
  const auto by_ins = [&](const pipeline::PipelineOutput& a, const pipeline::PipelineOutput& b) {
    return RigidTransform(b.result.mounting.ins_from_lidar().inverse() * pair.ins_b_from_ins_a *
                          a.result.mounting.ins_from_lidar());
  };
  PairTransforms transforms;
  transforms.before_lidar_b_from_lidar_a = by_ins(alone_a, alone_b);
  transforms.current_lidar_b_from_lidar_a = by_ins(of_a, of_b);
  transforms.current_known = true;
  transforms.registered_lidar_b_from_lidar_a =
      pair.registration.attempted ? pair.lidar_b_from_lidar_a : transforms.before_lidar_b_from_lidar_a;
  transforms.view_from_lidar_b = of_b.result.mounting.ins_from_lidar();
  return transforms;
}

RigidTransform between(const RigidTransform& first, const RigidTransform& second, double share) {
  const Eigen::Quaterniond from(first.linear()), to(second.linear());
  return make_rigid(from.slerp(share, to).toRotationMatrix(),
                    (1.0 - share) * first.translation() + share * second.translation());
}

PairSceneDataPtr prepare_pair_scene(std::shared_ptr<const pipeline::PairClouds> clouds, const Progress& progress) {
  ScanScenes alone;
  return prepare_pair_scene(std::move(clouds), alone, progress);
}

std::shared_ptr<ScanScenes> make_scan_scenes() { return std::make_shared<ScanScenes>(); }

void tell_ground_apart(ScanScenes& scans, bool on) { scans.tell_ground_apart(on); }

PairSceneDataPtr prepare_pair_scene(std::shared_ptr<const pipeline::PairClouds> clouds, ScanScenes& scans,
                                    const Progress& progress) {
  ScanScenePtr scan_a = scans.prepare(clouds->scan_a, progress), scan_b = scans.prepare(clouds->scan_b, progress);
  if (!scan_a || !scan_b) return nullptr;
  std::vector<ObjectBox> boxes_a, boxes_b;
  for (const cloud::ObjectMatch& match : clouds->matches) {
    boxes_a.push_back({&clouds->scan_a->objects.at(match.object_a), match.moving});
    boxes_b.push_back({&clouds->scan_b->objects.at(match.object_b), match.moving});
  }
  return std::make_shared<const PairSceneData>(PairSceneData{std::move(clouds), std::move(scan_a), std::move(scan_b),
                                                             polydata_from_boxes(boxes_a, kObjectA, kMoving),
                                                             polydata_from_boxes(boxes_b, kObjectB, kMoving)});
}

std::shared_ptr<const pipeline::PairClouds> clouds_of(const PairSceneData& data) { return data.clouds; }

std::size_t SceneMemory::add(const PairSceneData& data) {
  for (const ScanScenePtr& scan : {data.scan_a, data.scan_b})
    if (counted_.insert(scan.get()).second) bytes_ += scan->bytes();
  return bytes_;
}

std::vector<float> distances_to_target(const PairSceneData& data, const RigidTransform& lidar_b_from_lidar_a,
                                       const Progress& progress) {
  const std::shared_ptr<const quality::SurfaceDistance> surfaces = data.scan_b->surfaces(progress);
  if (progress.cancelled()) return {};
  return surfaces->signed_of(data.cloud_a().cloud->points, lidar_b_from_lidar_a, progress);
}

}  // namespace remount::scene
