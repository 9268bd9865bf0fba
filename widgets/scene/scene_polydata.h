// VTK geometry from objects.
#pragma once

#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <vector>

#include "algorithms/cloud/objects.h"
#include "widgets/scene/distance_scale.h"

namespace remount::scene {

/// One object to be drawn as a box; moving ones are crossed out.
struct ObjectBox {
  const cloud::SceneObject* object = nullptr;
  bool moving = false;
};

/// Edges of the boxes in the lidar frame, coloured by `still` or `moving`.
vtkSmartPointer<vtkPolyData> polydata_from_boxes(const std::vector<ObjectBox>& boxes, SceneColor still,
                                                 SceneColor moving);

/// Lines between matched centroids, in the frame of lidar b.
vtkSmartPointer<vtkPolyData> polydata_from_links(const std::vector<cloud::SceneObject>& objects_a,
                                                 const std::vector<cloud::SceneObject>& objects_b,
                                                 const std::vector<cloud::ObjectMatch>& matches,
                                                 const RigidTransform& lidar_b_from_lidar_a, SceneColor still,
                                                 SceneColor moving);

}  // namespace remount::scene
