#include "widgets/scene/pair_scene.h"

#include <vtkActor.h>
#include <vtkMatrix4x4.h>
#include <vtkNew.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>

#include <algorithm>
#include <cmath>

#include "algorithms/core/index.h"
#include "widgets/scene/frame_budget.h"
#include "widgets/scene/pair_colors.h"
#include "widgets/scene/pair_scene_parts.h"
#include "widgets/scene/scene_polydata.h"

namespace remount::scene {
// Named, for a class of this file holds them, and its files are compiled as one with others.
namespace pair_pictures {

/// Lines in one lidar frame.
struct Lines {
  vtkNew<vtkPolyDataMapper> mapper;
  vtkNew<vtkActor> actor;

  explicit Lines(vtkRenderer& renderer) {
    mapper->SetInputData(vtkNew<vtkPolyData>());
    actor->SetMapper(mapper);
    actor->GetProperty()->LightingOff();
    actor->GetProperty()->SetLineWidth(1.5F);
    renderer.AddActor(actor);
  }
  void place(const RigidTransform& view_from_lidar) {
    vtkNew<vtkMatrix4x4> matrix;
    for (int row = 0; row < 4; ++row)
      for (int column = 0; column < 4; ++column) matrix->SetElement(row, column, view_from_lidar.matrix()(row, column));
    actor->SetUserMatrix(matrix);
  }
};

/// One of the pictures.
struct Picture {
  CloudActor target, source;
  Lines boxes_a, boxes_b, links;
  RigidTransform lidar_b_from_lidar_a = RigidTransform::Identity();
  std::vector<float> distances_m;

  Picture(vtkRenderer& clouds, vtkRenderer& lines)
      : target(clouds), source(clouds), boxes_a(lines), boxes_b(lines), links(lines) {}
};

}  // namespace pair_pictures

namespace {

PairSceneDataPtr empty_data() { return prepare_pair_scene(std::make_shared<const pipeline::PairClouds>(), {}); }

}  // namespace

using pair_pictures::Lines;
using pair_pictures::Picture;

struct PairScene::Parts {
  SceneStage stage;
  std::array<Picture, SceneStage::kPanes> pictures{Picture{stage.pane(0), stage.overlay(0)},
                                                   Picture{stage.pane(1), stage.overlay(1)}};
  PairSceneDataPtr data = empty_data();
  PairTransforms transforms;
  PairAlignment after = PairAlignment::Registered;
  double share = 1.0, pixel_ratio = 1.0;
  bool side_by_side = false, dark = false, moving = false;
  SourceColoring coloring = SourceColoring::Orange;
  DistanceScale scale;
  FrameBudget budget;
  std::size_t shown = 0;

  RigidTransform wanted(int pane) const {
    const RigidTransform& before = transforms.before_lidar_b_from_lidar_a;
    if (side_by_side && pane == 0) return before;
    return between(before, transforms.of(after), share);
  }

  void place() {
    for (int i = 0; i < SceneStage::kPanes; ++i) {
      Picture& picture = pictures[index_at(i)];
      picture.lidar_b_from_lidar_a = wanted(i);
      const RigidTransform view_from_lidar_a = transforms.view_from_lidar_b * picture.lidar_b_from_lidar_a;
      picture.target.place(transforms.view_from_lidar_b);
      picture.boxes_b.place(transforms.view_from_lidar_b);
      picture.links.place(transforms.view_from_lidar_b);
      picture.source.place(view_from_lidar_a);
      picture.boxes_a.place(view_from_lidar_a);
      picture.links.mapper->SetInputData(polydata_from_links(data->clouds->objects_a, data->clouds->objects_b,
                                                             data->clouds->matches, picture.lidar_b_from_lidar_a, kLink,
                                                             kMoving));
    }
  }

  void color() {
    const ScanColors scans = scan_colors(dark);
    for (Picture& picture : pictures) {
      picture.target.set_color(scans.target);
      picture.source.set_color(coloring == SourceColoring::Blue       ? scans.blue
                               : coloring == SourceColoring::Distance ? DistanceScale::kNothingNear
                                                                      : scans.orange);
      const bool known = coloring == SourceColoring::Distance && !picture.distances_m.empty();
      picture.source.set_colors(
          known ? std::make_shared<const std::vector<SceneColor>>(scale.colors(picture.distances_m)) : nullptr);
    }
  }

  void size_points() {
    const auto pixels = static_cast<float>((stage.eye_dome() ? 3.0 : 2.0) * pixel_ratio);
    for (Picture& picture : pictures) {
      picture.target.set_point_size(pixels);
      picture.source.set_point_size(pixels);
    }
  }

  void thin() {
    const std::size_t all = data->cloud_a->size() + data->cloud_b->size();
    const auto panes = static_cast<std::size_t>(stage.shown_panes());
    const double share_drawn =
        moving && all > 0 ? std::min(1.0, static_cast<double>(budget.points()) / static_cast<double>(panes * all))
                          : 1.0;
    const auto part = [&](std::size_t size) {
      return static_cast<std::size_t>(share_drawn * static_cast<double>(size));
    };
    for (Picture& picture : pictures)
      shown = picture.source.show(part(data->cloud_a->size())) + picture.target.show(part(data->cloud_b->size()));
  }
};

PairScene::PairScene() : parts_(std::make_unique<Parts>()) {
  set_dark(false);
  // How long frames take sets how thin the cloud is while the camera moves.
  parts_->stage.on_frame([&p = *parts_](double seconds) {
    p.budget.took(p.shown * static_cast<std::size_t>(p.stage.shown_panes()), seconds);
    if (p.moving) p.thin();
  });
}

PairScene::~PairScene() { parts_->stage.on_frame({}); }

SceneStage& PairScene::stage() { return parts_->stage; }

void PairScene::set_pair(PairSceneDataPtr data, const PairTransforms& transforms) {
  Parts& p = *parts_;
  p.data = std::move(data);
  p.transforms = transforms;
  for (Picture& picture : p.pictures) {
    picture.distances_m.clear();
    picture.target.set_geometry(p.data->cloud_b);
    picture.source.set_geometry(p.data->cloud_a);
    picture.boxes_a.mapper->SetInputData(p.data->boxes_a);
    picture.boxes_b.mapper->SetInputData(p.data->boxes_b);
  }
  p.stage.frame(robust_framing(p.data->clouds->cloud_b.points, transforms.view_from_lidar_b));
  p.place();
  p.color();
  p.size_points();
  p.thin();
}

void PairScene::set_transforms(const PairTransforms& transforms) {
  parts_->transforms = transforms;
  parts_->place();
}

void PairScene::clear() { set_pair(empty_data(), PairTransforms{}); }

void PairScene::show(PairAlignment after, double share, bool side_by_side) {
  Parts& p = *parts_;
  p.after = after;
  p.share = share;
  p.side_by_side = side_by_side;
  p.stage.show_panes(side_by_side ? 2 : 1);
  p.place();
  p.thin();
}

RigidTransform PairScene::lidar_b_from_lidar_a(int pane) const {
  return parts_->pictures.at(index_at(pane)).lidar_b_from_lidar_a;
}

void PairScene::show_objects(bool visible) {
  for (Picture& picture : parts_->pictures)
    for (Lines* lines : {&picture.boxes_a, &picture.boxes_b, &picture.links}) lines->actor->SetVisibility(visible);
}

bool PairScene::has_objects(bool moving) const {
  const auto& matches = parts_->data->clouds->matches;
  return std::any_of(matches.begin(), matches.end(),
                     [&](const cloud::ObjectMatch& match) { return match.moving == moving; });
}

void PairScene::set_dark(bool dark) {
  parts_->dark = dark;
  parts_->stage.set_dark(dark);
  parts_->color();
}

void PairScene::set_pixel_ratio(double device_pixels) {
  parts_->pixel_ratio = device_pixels;
  parts_->size_points();
}

void PairScene::set_coloring(SourceColoring coloring) {
  parts_->coloring = coloring;
  parts_->color();
}

void PairScene::set_scale(double limit_m) {
  parts_->scale = DistanceScale(limit_m);
  parts_->color();
}

void PairScene::set_distances(int pane, std::vector<float> distances_m) {
  parts_->pictures.at(index_at(pane)).distances_m = std::move(distances_m);
  parts_->color();
}

void PairScene::set_moving(bool moving) {
  parts_->moving = moving;
  parts_->thin();
}

std::optional<PairPick> PairScene::pick(const PickRay& ray) const {
  const Parts& p = *parts_;
  const RigidTransform& b_from_a = p.pictures.at(index_at(ray.pane)).lidar_b_from_lidar_a;
  const RigidTransform view_from_a = p.transforms.view_from_lidar_b * b_from_a;
  const auto in_a = nearest_to_ray(p.data->cloud_a->cloud->points, view_from_a, ray);
  const auto in_b = nearest_to_ray(p.data->cloud_b->cloud->points, p.transforms.view_from_lidar_b, ray);
  if (!in_a && !in_b) return std::nullopt;
  PairPick pick;
  // Of two that look like one, the one in front; else the one nearer to the click.
  if (in_a && in_b)
    pick.in_scan_a = std::abs(in_a->angle_rad - in_b->angle_rad) < ray.pixel_rad ? in_a->distance_m < in_b->distance_m
                                                                                 : in_a->angle_rad < in_b->angle_rad;
  else
    pick.in_scan_a = in_a.has_value();
  const LevelCloud& cloud = *(pick.in_scan_a ? p.data->cloud_a : p.data->cloud_b)->cloud;
  const Eigen::Vector3f point = cloud.points[(pick.in_scan_a ? in_a : in_b)->index];
  pick.point_in_lidar = point.cast<double>();
  pick.point_in_view = (pick.in_scan_a ? view_from_a : p.transforms.view_from_lidar_b) * pick.point_in_lidar;
  pick.distance_m = pick.in_scan_a ? p.data->surfaces_b.of({point}, b_from_a).front()
                                   : p.data->surfaces_a.of({point}, b_from_a.inverse()).front();
  return pick;
}

std::size_t PairScene::points_shown() const { return parts_->shown; }

std::size_t PairScene::points_in_all() const { return parts_->data->cloud_a->size() + parts_->data->cloud_b->size(); }

}  // namespace remount::scene
