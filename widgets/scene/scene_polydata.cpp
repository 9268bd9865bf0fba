#include "widgets/scene/scene_polydata.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkPoints.h>
#include <vtkUnsignedCharArray.h>

namespace remount::scene {
namespace {

struct LineBuilder {
  vtkSmartPointer<vtkPoints> points = vtkSmartPointer<vtkPoints>::New();
  vtkSmartPointer<vtkCellArray> lines = vtkSmartPointer<vtkCellArray>::New();
  vtkSmartPointer<vtkUnsignedCharArray> colors = vtkSmartPointer<vtkUnsignedCharArray>::New();

  LineBuilder() { colors->SetNumberOfComponents(3); }

  void line(const Eigen::Vector3d& from, const Eigen::Vector3d& to, const SceneColor& color) {
    const vtkIdType ends[2] = {points->InsertNextPoint(from.data()), points->InsertNextPoint(to.data())};
    lines->InsertNextCell(2, ends);
    colors->InsertNextTypedTuple(color.data());
  }

  vtkSmartPointer<vtkPolyData> build() const {
    auto data = vtkSmartPointer<vtkPolyData>::New();
    data->SetPoints(points);
    data->SetLines(lines);
    data->GetCellData()->SetScalars(colors);
    return data;
  }
};

Eigen::Vector3d corner(const cloud::SceneObject& object, int index) {
  const auto pick = [&](int axis) {
    return static_cast<double>((index >> axis) & 1 ? object.box_max_in_lidar[axis] : object.box_min_in_lidar[axis]);
  };
  return {pick(0), pick(1), pick(2)};
}

void add_box(LineBuilder& builder, const ObjectBox& box, const SceneColor& color) {
  for (int from = 0; from < 8; ++from) {
    for (int axis = 0; axis < 3; ++axis) {
      const int to = from | (1 << axis);
      if (to != from) builder.line(corner(*box.object, from), corner(*box.object, to), color);
    }
  }
  if (!box.moving) return;
  for (int from = 0; from < 4; ++from) builder.line(corner(*box.object, from), corner(*box.object, 7 - from), color);
}

}  // namespace

vtkSmartPointer<vtkPolyData> polydata_from_boxes(const std::vector<ObjectBox>& boxes, SceneColor still,
                                                 SceneColor moving) {
  LineBuilder builder;
  for (const ObjectBox& box : boxes) add_box(builder, box, box.moving ? moving : still);
  return builder.build();
}

vtkSmartPointer<vtkPolyData> polydata_from_links(const std::vector<cloud::SceneObject>& objects_a,
                                                 const std::vector<cloud::SceneObject>& objects_b,
                                                 const std::vector<cloud::ObjectMatch>& matches,
                                                 const RigidTransform& lidar_b_from_lidar_a, SceneColor still,
                                                 SceneColor moving) {
  LineBuilder builder;
  for (const cloud::ObjectMatch& match : matches) {
    const Eigen::Vector3d from = lidar_b_from_lidar_a * objects_a.at(match.object_a).centroid_in_lidar.cast<double>();
    const Eigen::Vector3d to = objects_b.at(match.object_b).centroid_in_lidar.cast<double>();
    builder.line(from, to, match.moving ? moving : still);
  }
  return builder.build();
}

}  // namespace remount::scene
