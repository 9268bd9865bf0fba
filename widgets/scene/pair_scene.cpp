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
#include "widgets/scene/point_property.h"
#include "widgets/scene/scene_polydata.h"
#include "widgets/scene/signed_scale.h"

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
  std::vector<float> distances_m;  // of all points of scan a, in their order

  Picture(vtkRenderer& clouds, vtkRenderer& lines)
      : target(clouds), source(clouds), boxes_a(lines), boxes_b(lines), links(lines) {}
};

}  // namespace pair_pictures

namespace {

constexpr double kFirstPicture_s = 0.03;

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
  PairColoring coloring = PairColoring::Orange;
  DistanceScale scale;
  FrameBudget budget;
  bool just_chosen = false;  // the pair: its first picture is there before it is waited for
  std::size_t shown = 0;
  bool ground = true;
  // Where the ground is hidden, the places of the points that are left.
  std::shared_ptr<const std::vector<std::uint32_t>> left_of_a, left_of_b;
  std::optional<ValueRange> range;

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
      picture.links.mapper->SetInputData(polydata_from_links(data->clouds->scan_a->objects,
                                                             data->clouds->scan_b->objects, data->clouds->matches,
                                                             picture.lidar_b_from_lidar_a, kLink, kMoving));
    }
  }

  void color() {
    const ScanColors scans = scan_colors(dark);
    const auto [of_a, of_b] = colors_by_property();
    for (Picture& picture : pictures) {
      picture.target.set_color(scans.target);
      picture.target.set_colors(of_b);
      picture.source.set_color(coloring == PairColoring::Blue ? scans.blue
                               : is_by_distance(coloring)     ? DistanceScale::kNothingNear
                                                              : scans.orange);
      picture.source.set_colors(is_by_distance(coloring) ? colors_by_distance(picture) : of_a);
    }
  }

  using Colors = std::shared_ptr<const std::vector<SceneColor>>;

  /// Of the points that are drawn.
  static Colors drawn_of(std::vector<SceneColor> all, const std::vector<std::uint32_t>* left) {
    if (!left) return std::make_shared<const std::vector<SceneColor>>(std::move(all));
    auto drawn = std::make_shared<std::vector<SceneColor>>();
    drawn->reserve(left->size());
    for (const std::uint32_t place : *left) drawn->push_back(all[place]);
    return drawn;
  }

  Colors colors_by_distance(const Picture& picture) const {
    if (picture.distances_m.empty()) return nullptr;
    if (coloring == PairColoring::Distance) return drawn_of(scale.colors(picture.distances_m), left_of_a.get());
    const SignedScale with_side(scale.limit_m());
    std::vector<SceneColor> colors;
    colors.reserve(picture.distances_m.size());
    for (const float distance_m : picture.distances_m) colors.push_back(with_side.color(distance_m));
    return drawn_of(std::move(colors), left_of_a.get());
  }

  /// Of scan a and scan b, on one range; null where they have none.
  std::pair<Colors, Colors> colors_by_property() {
    range.reset();
    const std::optional<PointProperty> property = property_of(coloring);
    if (!property) return {};
    RigidTransform level = RigidTransform::Identity();
    level.linear().row(2) = transforms.up_in_view.transpose();
    const RigidTransform level_from_b = level * transforms.view_from_lidar_b;
    const std::vector<float> of_b = scene::property_of(*data->scan_b, *property, level_from_b);
    const std::vector<float> of_a =
        scene::property_of(*data->scan_a, *property, level_from_b * transforms.registered_lidar_b_from_lidar_a);
    if (of_a.empty() || of_b.empty()) return {};
    range = range_of(of_a, of_b);
    return {drawn_of(colors_of(of_a, *range), left_of_a.get()), drawn_of(colors_of(of_b, *range), left_of_b.get())};
  }

  static std::optional<PointProperty> property_of(PairColoring coloring) {
    if (coloring == PairColoring::Height) return PointProperty::Height;
    if (coloring == PairColoring::Intensity) return PointProperty::Intensity;
    if (coloring == PairColoring::Ring) return PointProperty::Ring;
    if (coloring == PairColoring::Time) return PointProperty::Time;
    return std::nullopt;
  }

  /// What is drawn of a scan: all of it, or what stands above the ground.
  std::shared_ptr<const CloudGeometry> drawn(const ScanScene& scan, const std::vector<std::uint32_t>* left) const {
    if (!left) return scan.geometry();
    const LevelCloud& all = *scan.geometry()->cloud;
    LevelCloud above;
    above.points.reserve(left->size());
    for (const std::uint32_t place : *left) above.points.push_back(all.points[place]);
    return make_geometry(std::move(above));
  }

  void put_geometry() {
    left_of_a = left_of_b = nullptr;
    if (!ground) {
      left_of_a = data->scan_a->above_ground();
      left_of_b = data->scan_b->above_ground();
    }
    const auto of_a = drawn(*data->scan_a, left_of_a.get()), of_b = drawn(*data->scan_b, left_of_b.get());
    for (Picture& picture : pictures) {
      picture.target.set_geometry(of_b);
      picture.source.set_geometry(of_a);
    }
  }

  std::size_t drawn_points(const CloudActor& actor) const { return actor.geometry() ? actor.geometry()->size() : 0; }

  void size_points() {
    const auto pixels = static_cast<float>((stage.eye_dome() ? 3.0 : 2.0) * pixel_ratio);
    for (Picture& picture : pictures) {
      picture.target.set_point_size(pixels);
      picture.source.set_point_size(pixels);
    }
  }

  std::size_t affordable() const { return just_chosen ? budget.points_within(kFirstPicture_s) : budget.points(); }

  void thin() {
    const std::size_t of_a = drawn_points(pictures[0].source), of_b = drawn_points(pictures[0].target);
    const std::size_t all = of_a + of_b;
    const auto panes = static_cast<std::size_t>(stage.shown_panes());
    const double share_drawn =
        moving && all > 0 ? std::min(1.0, static_cast<double>(affordable()) / static_cast<double>(panes * all)) : 1.0;
    const auto part = [&](std::size_t size) {
      return static_cast<std::size_t>(share_drawn * static_cast<double>(size));
    };
    for (Picture& picture : pictures) shown = picture.source.show(part(of_a)) + picture.target.show(part(of_b));
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
  p.just_chosen = true;
  for (Picture& picture : p.pictures) {
    picture.distances_m.clear();
    picture.boxes_a.mapper->SetInputData(p.data->boxes_a);
    picture.boxes_b.mapper->SetInputData(p.data->boxes_b);
  }
  p.put_geometry();
  p.stage.frame(robust_framing(p.data->scan_b->cloud().points, transforms.view_from_lidar_b));
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

void PairScene::set_coloring(PairColoring coloring) {
  parts_->coloring = coloring;
  parts_->color();
}

std::optional<std::pair<double, double>> PairScene::value_range() const {
  if (!parts_->range) return std::nullopt;
  return std::pair(static_cast<double>(parts_->range->low), static_cast<double>(parts_->range->high));
}

void PairScene::show_ground(bool visible) {
  Parts& p = *parts_;
  p.ground = visible;
  p.put_geometry();
  p.place();
  p.color();
  p.size_points();
  p.thin();
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
  if (!moving) parts_->just_chosen = false;
  parts_->thin();
}

std::optional<PairPick> PairScene::pick(const PickRay& ray) const {
  const Parts& p = *parts_;
  const RigidTransform& b_from_a = p.pictures.at(index_at(ray.pane)).lidar_b_from_lidar_a;
  const RigidTransform view_from_a = p.transforms.view_from_lidar_b * b_from_a;
  const auto in_a = nearest_to_ray(p.data->cloud_a().cloud->points, view_from_a, ray);
  const auto in_b = nearest_to_ray(p.data->cloud_b().cloud->points, p.transforms.view_from_lidar_b, ray);
  if (!in_a && !in_b) return std::nullopt;
  PairPick pick;
  // Of two that look like one, the one in front; else the one nearer to the click.
  if (in_a && in_b)
    pick.in_scan_a = std::abs(in_a->angle_rad - in_b->angle_rad) < ray.pixel_rad ? in_a->distance_m < in_b->distance_m
                                                                                 : in_a->angle_rad < in_b->angle_rad;
  else
    pick.in_scan_a = in_a.has_value();
  const LevelCloud& cloud = *(pick.in_scan_a ? p.data->cloud_a() : p.data->cloud_b()).cloud;
  const Eigen::Vector3f point = cloud.points[(pick.in_scan_a ? in_a : in_b)->index];
  pick.point_in_lidar = point.cast<double>();
  pick.point_in_view = (pick.in_scan_a ? view_from_a : p.transforms.view_from_lidar_b) * pick.point_in_lidar;
  pick.distance_m = pick.in_scan_a ? p.data->scan_b->surfaces()->of({point}, b_from_a).front()
                                   : p.data->scan_a->surfaces()->of({point}, b_from_a.inverse()).front();
  return pick;
}

std::size_t PairScene::points_shown() const { return parts_->shown; }

std::size_t PairScene::points_in_all() const { return parts_->data->cloud_a().size() + parts_->data->cloud_b().size(); }

}  // namespace remount::scene
