// The inside of PairSceneData.
#pragma once

#include "algorithms/quality/surface_distance.h"
#include "widgets/scene/cloud_actor.h"
#include "widgets/scene/framing.h"
#include "widgets/scene/pair_scene_data.h"

namespace remount::scene {

struct PairSceneData {
  std::shared_ptr<const pipeline::PairClouds> clouds;
  std::shared_ptr<const CloudGeometry> cloud_a, cloud_b;
  quality::SurfaceDistance surfaces_a, surfaces_b;
  vtkSmartPointer<vtkPolyData> boxes_a, boxes_b;  // each in its own lidar frame
};

}  // namespace remount::scene
