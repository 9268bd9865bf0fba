#include "widgets/scene/path_scene.h"

#include <vtkActor.h>
#include <vtkCellArray.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>
#include <vtkSmartPointer.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <utility>

namespace remount::scene {
namespace {

constexpr float kLine_px = 2.0F, kDot_px = 5.0F;

vtkSmartPointer<vtkPolyData> polydata_of(const ScenePath& path, const Eigen::Vector3d& origin_m) {
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> dots, lines;
  vtkIdType before = -1;
  for (const Eigen::Vector3d& point_m : path.points_m) {
    if (!point_m.allFinite()) {
      before = -1;
      continue;
    }
    const Eigen::Vector3d point_in_view = point_m - origin_m;
    const vtkIdType id = points->InsertNextPoint(point_in_view.data());
    const vtkIdType ends[2] = {before, id};
    if (path.dots)
      dots->InsertNextCell(1, &id);
    else if (before >= 0)
      lines->InsertNextCell(2, ends);
    before = id;
  }
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(points);
  data->SetVerts(dots);
  data->SetLines(lines);
  return data;
}

Eigen::AlignedBox3d box_of(const std::vector<ScenePath>& paths, bool dots) {
  Eigen::AlignedBox3d box;
  for (const ScenePath& path : paths)
    for (const Eigen::Vector3d& point_m : path.points_m)
      if (path.dots == dots && point_m.allFinite()) box.extend(point_m);
  return box;
}

/// A way is looked at as a whole, its ends included; single points may be far off and count where there is no way.
Framing framing_of(const std::vector<ScenePath>& paths, const Eigen::Vector3d& origin_m) {
  Eigen::AlignedBox3d box = box_of(paths, false);
  if (box.isEmpty()) box = box_of(paths, true);
  Framing framing;
  if (box.isEmpty()) return framing;
  framing.centre_m = box.center() - origin_m;
  // A stage comes closer than its framing, as suits clouds of points.
  constexpr double kMargin = 1.25;
  framing.radius_m = std::max(1.0, kMargin * 0.5 * box.diagonal().norm());
  return framing;
}

}  // namespace

struct PathScene::Parts {
  SceneStage stage;
  std::vector<vtkSmartPointer<vtkActor>> actors;
  std::vector<ScenePath> paths;
  Eigen::Vector3d origin_m = Eigen::Vector3d::Zero();
  std::vector<Eigen::Vector3f> points_in_view;                  // of all paths, for picking
  std::vector<std::pair<std::size_t, std::size_t>> path_point;  // which of which path each is
  double pixel_ratio = 1.0;

  void size_actors() {
    for (const auto& actor : actors) {
      actor->GetProperty()->SetLineWidth(kLine_px * static_cast<float>(pixel_ratio));
      actor->GetProperty()->SetPointSize(kDot_px * static_cast<float>(pixel_ratio));
    }
  }
};

PathScene::PathScene() : parts_(std::make_unique<Parts>()) {}

PathScene::~PathScene() = default;

SceneStage& PathScene::stage() { return parts_->stage; }

void PathScene::show(const std::vector<ScenePath>& paths) {
  Parts& p = *parts_;
  vtkRenderer& renderer = p.stage.overlay(0);
  for (const auto& actor : p.actors) renderer.RemoveViewProp(actor);
  p.actors.clear();
  p.points_in_view.clear();
  p.path_point.clear();
  p.paths = paths;
  bool any = false;
  for (std::size_t path = 0; path < paths.size(); ++path)
    for (std::size_t i = 0; i < paths[path].points_m.size(); ++i) {
      const Eigen::Vector3d& point_m = paths[path].points_m[i];
      if (!point_m.allFinite()) continue;
      if (!std::exchange(any, true)) p.origin_m = point_m;
      p.points_in_view.push_back((point_m - p.origin_m).cast<float>());
      p.path_point.emplace_back(path, i);
    }
  for (const ScenePath& path : paths) {
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputData(polydata_of(path, p.origin_m));
    auto actor = vtkSmartPointer<vtkActor>::New();
    actor->SetMapper(mapper);
    actor->GetProperty()->LightingOff();
    actor->GetProperty()->SetColor(path.color[0] / 255.0, path.color[1] / 255.0, path.color[2] / 255.0);
    renderer.AddViewProp(actor);
    p.actors.push_back(actor);
  }
  p.size_actors();
  p.stage.frame(framing_of(paths, p.origin_m));
}

void PathScene::set_pixel_ratio(double device_pixels) {
  parts_->pixel_ratio = device_pixels;
  parts_->size_actors();
}

std::optional<PathScene::Picked> PathScene::pick(const PickRay& ray) const {
  const Parts& p = *parts_;
  const auto picked = nearest_to_ray(p.points_in_view, RigidTransform::Identity(), ray);
  if (!picked) return std::nullopt;
  const auto [path, point] = p.path_point[picked->index];
  const Eigen::Vector3d& point_m = p.paths[path].points_m[point];
  return Picked{path, point_m, point_m - p.origin_m};
}

}  // namespace remount::scene
