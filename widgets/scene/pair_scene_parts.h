// The inside of PairSceneData.
#pragma once

#include "widgets/scene/framing.h"
#include "widgets/scene/pair_scene_data.h"
#include "widgets/scene/scan_scene.h"

namespace remount::scene {

struct PairSceneData {
  std::shared_ptr<const pipeline::PairClouds> clouds;
  ScanScenePtr scan_a, scan_b;
  vtkSmartPointer<vtkPolyData> boxes_a, boxes_b;  // each in its own lidar frame

  const CloudGeometry& cloud_a() const { return *scan_a->geometry(); }
  const CloudGeometry& cloud_b() const { return *scan_b->geometry(); }
};

}  // namespace remount::scene
