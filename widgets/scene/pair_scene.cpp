#include "widgets/scene/pair_scene.h"

#include <vtkActor.h>
#include <vtkAxesActor.h>
#include <vtkCamera.h>
#include <vtkCaptionActor2D.h>
#include <vtkMatrix4x4.h>
#include <vtkNew.h>
#include <vtkOrientationMarkerWidget.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderWindow.h>
#include <vtkRenderWindowInteractor.h>
#include <vtkRenderer.h>
#include <vtkTextActor.h>
#include <vtkTextProperty.h>

#include <cmath>

#include "widgets/scene/framing.h"
#include "widgets/scene/scene_polydata.h"
#include "widgets/scene/turntable_style.h"

namespace remount {
namespace {

struct Palette {
  std::array<double, 3> background_bottom, background_top, target, source, text;
};
constexpr Palette kLight{
    {0.93, 0.94, 0.95}, {0.98, 0.98, 0.99}, {0.46, 0.48, 0.52}, {0.85, 0.29, 0.02}, {0.1, 0.1, 0.12}};
constexpr Palette kDark{
    {0.08, 0.09, 0.10}, {0.14, 0.15, 0.17}, {0.62, 0.65, 0.69}, {1.0, 0.62, 0.20}, {0.9, 0.9, 0.92}};
constexpr SceneColor kObjectB{30, 120, 200}, kObjectA{20, 160, 110}, kLink{20, 140, 150}, kMoving{220, 30, 40};

void set_matrix(vtkActor& actor, const RigidTransform& view_from_local) {
  vtkNew<vtkMatrix4x4> matrix;
  for (int row = 0; row < 4; ++row)
    for (int column = 0; column < 4; ++column) matrix->SetElement(row, column, view_from_local.matrix()(row, column));
  actor.SetUserMatrix(matrix);
}

struct Layer {
  vtkNew<vtkPolyDataMapper> mapper;
  vtkNew<vtkActor> actor;

  Layer() {
    mapper->SetInputData(vtkNew<vtkPolyData>());
    actor->SetMapper(mapper);
    actor->GetProperty()->LightingOff();
    actor->GetProperty()->SetLineWidth(1.5F);
    actor->GetProperty()->SetPointSize(2.0F);
  }
};

}  // namespace

PairTransforms pair_transforms(const PipelineOutput& output, int pair) {
  const Pair& chosen = output.pairs.at(static_cast<std::size_t>(pair));
  const RigidTransform& initial = output.initial_ins_from_lidar;
  const Status status = output.result.status;
  const bool solved = status == Status::Ok || status == Status::Degenerate || status == Status::Inconsistent;
  const RigidTransform& current = solved ? output.result.ins_from_lidar : initial;
  PairTransforms transforms;
  transforms.before_lidar_b_from_lidar_a = initial.inverse() * chosen.ins_b_from_ins_a * initial;
  transforms.current_lidar_b_from_lidar_a = current.inverse() * chosen.ins_b_from_ins_a * current;
  transforms.registered_lidar_b_from_lidar_a =
      chosen.registration.attempted ? chosen.lidar_b_from_lidar_a : transforms.before_lidar_b_from_lidar_a;
  transforms.view_from_lidar_b = current;
  return transforms;
}

struct PairScene::Parts {
  vtkNew<vtkRenderer> renderer;
  vtkNew<TurntableStyle> style;
  vtkNew<vtkAxesActor> axes;
  vtkNew<vtkOrientationMarkerWidget> marker;
  Layer target, source, boxes_a, boxes_b, links;
  std::vector<SceneObject> objects_a, objects_b;
  std::vector<ObjectMatch> matches;
  PairTransforms transforms;
  PairAlignment alignment = PairAlignment::Registered;
  Framing framing;

  const RigidTransform& lidar_b_from_lidar_a() const {
    if (alignment == PairAlignment::Before) return transforms.before_lidar_b_from_lidar_a;
    if (alignment == PairAlignment::CurrentX) return transforms.current_lidar_b_from_lidar_a;
    return transforms.registered_lidar_b_from_lidar_a;
  }

  void place() {
    const RigidTransform view_from_lidar_a = transforms.view_from_lidar_b * lidar_b_from_lidar_a();
    set_matrix(*target.actor, transforms.view_from_lidar_b);
    set_matrix(*boxes_b.actor, transforms.view_from_lidar_b);
    set_matrix(*links.actor, transforms.view_from_lidar_b);
    set_matrix(*source.actor, view_from_lidar_a);
    set_matrix(*boxes_a.actor, view_from_lidar_a);
    links.mapper->SetInputData(
        polydata_from_links(objects_a, objects_b, matches, lidar_b_from_lidar_a(), kLink, kMoving));
  }

  void set_axis_color(const std::array<double, 3>& color) {
    for (vtkCaptionActor2D* caption :
         {axes->GetXAxisCaptionActor2D(), axes->GetYAxisCaptionActor2D(), axes->GetZAxisCaptionActor2D()}) {
      caption->GetCaptionTextProperty()->SetColor(color[0], color[1], color[2]);
      caption->GetCaptionTextProperty()->ShadowOff();
      caption->GetCaptionTextProperty()->ItalicOff();
      caption->GetCaptionTextProperty()->BoldOff();
      caption->GetCaptionTextProperty()->SetFontSize(13);
      caption->GetTextActor()->SetTextScaleModeToNone();
    }
  }
};

PairScene::PairScene() : parts_(std::make_unique<Parts>()) {
  Parts& p = *parts_;
  for (Layer* layer : {&p.target, &p.source, &p.boxes_b, &p.boxes_a, &p.links}) p.renderer->AddActor(layer->actor);
  p.renderer->SetGradientBackground(true);
  p.axes->SetXAxisLabelText("x");
  p.axes->SetYAxisLabelText("y");
  p.axes->SetZAxisLabelText("z");
  p.marker->SetOrientationMarker(p.axes);
  set_dark(false);
}

PairScene::~PairScene() {
  if (!parts_->marker->GetInteractor()) return;  // never attached
  parts_->marker->SetEnabled(0);
  parts_->marker->SetInteractor(nullptr);
}

void PairScene::attach(vtkRenderWindow& window) {
  Parts& p = *parts_;
  window.AddRenderer(p.renderer);
  window.GetInteractor()->SetInteractorStyle(p.style);
  p.marker->SetInteractor(window.GetInteractor());
  p.marker->SetViewport(0.0, 0.0, 0.2, 0.25);
  p.marker->SetEnabled(1);
  p.marker->InteractiveOff();
  look(StandardView::Fit);
}

void PairScene::set_pair(const PairClouds& clouds, const PairTransforms& transforms) {
  Parts& p = *parts_;
  p.objects_a = clouds.objects_a;
  p.objects_b = clouds.objects_b;
  p.matches = clouds.matches;
  p.transforms = transforms;
  p.target.mapper->SetInputData(polydata_from_cloud(clouds.cloud_b));
  p.source.mapper->SetInputData(polydata_from_cloud(clouds.cloud_a));
  std::vector<ObjectBox> boxes_a, boxes_b;
  for (const ObjectMatch& match : p.matches) {
    boxes_a.push_back({&p.objects_a.at(static_cast<std::size_t>(match.object_a)), match.moving});
    boxes_b.push_back({&p.objects_b.at(static_cast<std::size_t>(match.object_b)), match.moving});
  }
  p.boxes_a.mapper->SetInputData(polydata_from_boxes(boxes_a, kObjectA, kMoving));
  p.boxes_b.mapper->SetInputData(polydata_from_boxes(boxes_b, kObjectB, kMoving));
  p.framing = robust_framing(clouds.cloud_b.points, transforms.view_from_lidar_b);
  p.place();
  p.renderer->ResetCameraClippingRange();
}

void PairScene::set_transforms(const PairTransforms& transforms) {
  parts_->transforms = transforms;
  parts_->place();
}

void PairScene::clear() { set_pair(PairClouds{}, PairTransforms{}); }

void PairScene::show_alignment(PairAlignment alignment) {
  parts_->alignment = alignment;
  parts_->place();
}

void PairScene::show_objects(bool visible) {
  for (Layer* layer : {&parts_->boxes_a, &parts_->boxes_b, &parts_->links}) layer->actor->SetVisibility(visible);
}

void PairScene::set_dark(bool dark) {
  const Palette& palette = dark ? kDark : kLight;
  Parts& p = *parts_;
  p.renderer->SetBackground(palette.background_bottom.data());
  p.renderer->SetBackground2(palette.background_top.data());
  const auto set_color = [](vtkActor& actor, const std::array<double, 3>& c) {
    actor.GetProperty()->SetColor(c[0], c[1], c[2]);
  };
  set_color(*p.target.actor, palette.target);
  set_color(*p.source.actor, palette.source);
  p.set_axis_color(palette.text);
}

void PairScene::look(StandardView view) {
  Parts& p = *parts_;
  vtkCamera& camera = *p.renderer->GetActiveCamera();
  const double distance_m = 0.85 * p.framing.radius_m / std::sin(0.5 * degrees_to_radians(camera.GetViewAngle()));
  // Where the camera stands: above, on the right, ahead; "fit" from behind and above, as from a following car.
  double azimuth = kPi, elevation = 0.5 * kPi;
  if (view == StandardView::Side) azimuth = -0.5 * kPi, elevation = 0.0;
  if (view == StandardView::Front) azimuth = 0.0, elevation = 0.0;
  if (view == StandardView::Fit) azimuth = degrees_to_radians(-155.0), elevation = degrees_to_radians(35.0);
  place_camera(camera, p.framing.centre_m.data(), distance_m, azimuth, elevation);
  p.renderer->ResetCameraClippingRange();
}

}  // namespace remount
