#include "widgets/scene/scene_stage.h"

#include <vtkAxesActor.h>
#include <vtkCamera.h>
#include <vtkCaptionActor2D.h>
#include <vtkNew.h>
#include <vtkOpenGLRenderer.h>
#include <vtkOrientationMarkerWidget.h>
#include <vtkRenderStepsPass.h>
#include <vtkRenderWindow.h>
#include <vtkRenderWindowInteractor.h>
#include <vtkTextActor.h>
#include <vtkTextProperty.h>

#include <array>
#include <chrono>
#include <cmath>

#include "algorithms/core/index.h"
#include "widgets/scene/eye_dome_pass.h"
#include "widgets/scene/mark_actor.h"
#include "widgets/scene/scene_observer.h"
#include "widgets/scene/turntable_style.h"

namespace remount::scene {
namespace {

using Clock = std::chrono::steady_clock;
using Rgb = std::array<double, 3>;
struct Palette {
  Rgb background_bottom, background_top, text;
};
constexpr Palette kLight{{0.93, 0.94, 0.95}, {0.98, 0.98, 0.99}, {0.1, 0.1, 0.12}};
constexpr Palette kDark{{0.08, 0.09, 0.10}, {0.14, 0.15, 0.17}, {0.9, 0.9, 0.92}};
// Of the radius of what is framed: farther behind it nothing is drawn, or the depth buffer would be spent on stray
// points.
constexpr double kDepthReach = 8.0;
// Of the distance at which a camera in parallel stands: from there its rays start.
constexpr double kAway = 100.0;

void set_axis_color(vtkAxesActor& axes, const Rgb& color) {
  for (vtkCaptionActor2D* caption :
       {axes.GetXAxisCaptionActor2D(), axes.GetYAxisCaptionActor2D(), axes.GetZAxisCaptionActor2D()}) {
    caption->GetCaptionTextProperty()->SetColor(color[0], color[1], color[2]);
    caption->GetCaptionTextProperty()->ShadowOff();
    caption->GetCaptionTextProperty()->ItalicOff();
    caption->GetCaptionTextProperty()->BoldOff();
    caption->GetCaptionTextProperty()->SetFontSize(13);
    caption->GetTextActor()->SetTextScaleModeToNone();
  }
}

}  // namespace

struct SceneStage::Parts {
  struct Pane {
    vtkNew<vtkOpenGLRenderer> scene, overlay;  // what is in the overlay is not shaded by the eye-dome lighting
    MarkActor marks{*overlay};
  };
  std::array<Pane, kPanes> panes;
  vtkNew<vtkCamera> camera;
  vtkNew<TurntableStyle> style;
  vtkNew<vtkAxesActor> axes;
  vtkNew<vtkOrientationMarkerWidget> marker;
  std::vector<std::unique_ptr<SceneObserver>> observers;
  vtkRenderWindow* window = nullptr;
  Framing framing;
  int shown = 1;
  bool eye_dome = false;
  Clock::time_point frame_began;
  double forward_rad = 0.0;
  std::function<void(double)> frame_listener;
  std::function<void(bool)> motion_listener;
  std::function<void()> drawn_listener;

  double half_angle_rad() const { return 0.5 * degrees_to_radians(camera->GetViewAngle()); }
  Eigen::Vector3d position() const {
    double at[3];
    camera->GetPosition(at);
    return Eigen::Vector3d(at);
  }
  Eigen::Vector3d focus() const {
    double at[3];
    camera->GetFocalPoint(at);
    return Eigen::Vector3d(at);
  }
  /// A camera in parallel stands behind everything that is drawn: what it shows does not depend on where it stands.
  double parallel_distance_m() const { return 2.0 * kDepthReach * framing.radius_m; }
  void stand_at(double distance_m) {
    const Eigen::Vector3d at = focus() + distance_m * (position() - focus()).normalized();
    camera->SetPosition(at.x(), at.y(), at.z());
  }

  void limit_depth() {
    // From where the camera stands: a thousandth of the way to the far end is near enough to see what is looked at, and
    // leaves the depth buffer its precision.
    const double distance_m = (position() - framing.centre_m).norm();
    const double far_m = distance_m + kDepthReach * framing.radius_m;
    camera->SetClippingRange(std::min(0.1 * camera->GetDistance(), 2e-3 * far_m), std::max(far_m, 1e-3));
  }

  void observe(vtkObject& object, unsigned long event, std::function<void()> act) {
    observers.push_back(std::make_unique<SceneObserver>(object, event, std::move(act)));
  }
};

SceneStage::SceneStage() : parts_(std::make_unique<Parts>()) {
  Parts& p = *parts_;
  for (Parts::Pane& pane : p.panes) {
    pane.scene->SetGradientBackground(true);
    pane.overlay->SetLayer(1);
    pane.overlay->SetInteractive(0);
    // What is drawn over a picture later (keep_picture) must still find its depth.
    pane.overlay->SetPreserveDepthBuffer(1);
    for (vtkRenderer* renderer : {pane.scene.Get(), pane.overlay.Get()}) {
      renderer->SetActiveCamera(p.camera);
      renderer->UseFXAAOff();
    }
    p.observe(*pane.scene, vtkCommand::StartEvent, [&p] { p.limit_depth(); });
  }
  p.axes->SetXAxisLabelText("x");
  p.axes->SetYAxisLabelText("y");
  p.axes->SetZAxisLabelText("z");
  p.marker->SetOrientationMarker(p.axes);
  p.style->SetAutoAdjustCameraClippingRange(0);
  p.observe(*p.style, vtkCommand::StartInteractionEvent, [&p] {
    if (p.motion_listener) p.motion_listener(true);
  });
  p.observe(*p.style, vtkCommand::EndInteractionEvent, [&p] {
    if (p.motion_listener) p.motion_listener(false);
  });
  set_dark(false);
  show_panes(1);
  look(StandardView::Isometric);
}

SceneStage::~SceneStage() {
  parts_->observers.clear();
  if (!parts_->marker->GetInteractor()) return;  // never attached
  parts_->marker->SetEnabled(0);
  parts_->marker->SetInteractor(nullptr);
}

void SceneStage::attach(vtkRenderWindow& window) {
  Parts& p = *parts_;
  p.window = &window;
  window.SetNumberOfLayers(2);
  for (Parts::Pane& pane : p.panes) {
    window.AddRenderer(pane.scene);
    window.AddRenderer(pane.overlay);
  }
  window.GetInteractor()->SetInteractorStyle(p.style);
  p.marker->SetInteractor(window.GetInteractor());
  p.marker->SetViewport(0.0, 0.0, 0.2, 0.25);
  p.marker->SetEnabled(1);
  p.marker->InteractiveOff();
  p.observe(window, vtkCommand::StartEvent, [&p] { p.frame_began = Clock::now(); });
  p.observe(window, vtkCommand::EndEvent, [&p] {
    p.window->WaitForCompletion();  // or the time would be that of handing over the work
    if (p.drawn_listener) p.drawn_listener();
    if (p.frame_listener) p.frame_listener(std::chrono::duration<double>(Clock::now() - p.frame_began).count());
  });
}

vtkRenderer& SceneStage::overlay(int index) { return *parts_->panes.at(index_at(index)).overlay; }

vtkRenderer& SceneStage::pane(int index) { return *parts_->panes.at(index_at(index)).scene; }

void SceneStage::show_panes(int count) {
  parts_->shown = count;
  for (int i = 0; i < kPanes; ++i) {
    Parts::Pane& pane = parts_->panes[index_at(i)];
    const double left = count == 1 ? 0.0 : 0.5 * i, right = count == 1 ? 1.0 : 0.5 * (i + 1);
    for (vtkRenderer* renderer : {pane.scene.Get(), pane.overlay.Get()}) {
      renderer->SetViewport(left, 0.0, right, 1.0);
      renderer->SetDraw(i < count);
      renderer->SetInteractive(i < count && renderer == pane.scene.Get());
    }
  }
}

int SceneStage::shown_panes() const { return parts_->shown; }

void SceneStage::set_dark(bool dark) {
  const Palette& palette = dark ? kDark : kLight;
  for (Parts::Pane& pane : parts_->panes) {
    pane.scene->SetBackground(palette.background_bottom.data());
    pane.scene->SetBackground2(palette.background_top.data());
    pane.marks.set_text_colors(palette.text, palette.background_top);
  }
  set_axis_color(*parts_->axes, palette.text);
}

void SceneStage::set_eye_dome(bool on) {
  if (on == parts_->eye_dome) return;
  parts_->eye_dome = on;
  for (Parts::Pane& pane : parts_->panes) {
    if (!on) {
      const vtkSmartPointer<vtkRenderPass> former = pane.scene->GetPass();
      pane.scene->SetPass(nullptr);
      if (!former || !parts_->window) continue;
      parts_->window->MakeCurrent();
      former->ReleaseGraphicsResources(parts_->window);
      continue;
    }
    vtkNew<vtkRenderStepsPass> steps;
    vtkNew<EyeDomePass> shading;
    shading->SetDelegatePass(steps);
    pane.scene->SetPass(shading);
  }
}

bool SceneStage::eye_dome() const { return parts_->eye_dome; }

void SceneStage::frame(const Framing& framing) { parts_->framing = framing; }

void SceneStage::look(StandardView view) {
  Parts& p = *parts_;
  vtkCamera& camera = *p.camera;
  if (view == StandardView::Isometric) camera.ParallelProjectionOff();
  if (view == StandardView::Top || view == StandardView::Front || view == StandardView::Left)
    camera.ParallelProjectionOn();
  const double distance_m = 0.85 * p.framing.radius_m / std::sin(p.half_angle_rad());
  double azimuth = degrees_to_radians(-155.0), elevation = degrees_to_radians(35.0);  // as from a following car
  if (view == StandardView::Top) azimuth = kPi, elevation = 0.5 * kPi;
  if (view == StandardView::Left) azimuth = 0.5 * kPi, elevation = 0.0;
  if (view == StandardView::Front) azimuth = 0.0, elevation = 0.0;
  azimuth += p.forward_rad;
  if (view == StandardView::Fit) {
    const Eigen::Vector3d back = p.position() - p.focus();
    azimuth = std::atan2(back.y(), back.x());
    elevation = std::atan2(back.z(), std::hypot(back.x(), back.y()));
  }
  camera.SetParallelScale(distance_m * std::tan(p.half_angle_rad()));
  place_camera(camera, p.framing.centre_m.data(), parallel() ? p.parallel_distance_m() : distance_m, azimuth,
               elevation);
  p.limit_depth();
}

void SceneStage::set_parallel(bool on) {
  Parts& p = *parts_;
  if (on == parallel()) return;
  const double tangent = std::tan(p.half_angle_rad());
  if (on) p.camera->SetParallelScale((p.position() - p.focus()).norm() * tangent);
  p.camera->SetParallelProjection(on);
  p.stand_at(on ? p.parallel_distance_m() : p.camera->GetParallelScale() / tangent);
  p.limit_depth();
}

bool SceneStage::parallel() const { return parts_->camera->GetParallelProjection() != 0; }

void SceneStage::centre_on(const Eigen::Vector3d& point_in_view) {
  Parts& p = *parts_;
  const Eigen::Vector3d position = point_in_view + p.position() - p.focus();
  p.camera->SetFocalPoint(point_in_view.x(), point_in_view.y(), point_in_view.z());
  p.camera->SetPosition(position.x(), position.y(), position.z());
}

double SceneStage::metres_per_pixel() const {
  const Parts& p = *parts_;
  const int height_px = std::max(1, p.panes[0].scene->GetSize()[1]);
  const double half_m =
      parallel() ? p.camera->GetParallelScale() : (p.position() - p.focus()).norm() * std::tan(p.half_angle_rad());
  return 2.0 * half_m / height_px;
}

std::optional<PickRay> SceneStage::ray_at(double x_px, double y_px) const {
  const Parts& p = *parts_;
  for (int i = 0; i < p.shown; ++i) {
    vtkRenderer& renderer = *p.panes[index_at(i)].scene;
    const int* const size = renderer.GetSize();
    const int* const origin = renderer.GetOrigin();
    if (size[0] < 1 || size[1] < 1) continue;
    const double x = (x_px - origin[0]) / size[0], y = (y_px - origin[1]) / size[1];
    if (x < 0.0 || x > 1.0 || y < 0.0 || y > 1.0) continue;
    double right = 2.0 * x - 1.0, up = 2.0 * y - 1.0, far = 1.0;
    renderer.ViewToWorld(right, up, far);
    PickRay ray;
    if (parallel()) {
      // From so far away that its pixel is an angle, too.
      ray.direction_in_view = (p.focus() - p.position()).normalized();
      ray.origin_in_view = Eigen::Vector3d(right, up, far) - kAway * p.parallel_distance_m() * ray.direction_in_view;
      ray.pixel_rad = metres_per_pixel() / ((kAway - 1.0) * p.parallel_distance_m());
    } else {
      ray.origin_in_view = p.position();
      ray.direction_in_view = (Eigen::Vector3d(right, up, far) - ray.origin_in_view).normalized();
      ray.pixel_rad = degrees_to_radians(p.camera->GetViewAngle()) / size[1];
    }
    ray.pane = i;
    return ray;
  }
  return std::nullopt;
}

Eigen::Vector2d SceneStage::pixel_of(const Eigen::Vector3d& point_in_view, int pane) const {
  vtkRenderer& renderer = *parts_->panes.at(index_at(pane)).scene;
  double x = point_in_view.x(), y = point_in_view.y(), z = point_in_view.z();
  renderer.WorldToView(x, y, z);
  const int* const size = renderer.GetSize();
  const int* const origin = renderer.GetOrigin();
  return {origin[0] + 0.5 * (x + 1.0) * size[0], origin[1] + 0.5 * (y + 1.0) * size[1]};
}

void SceneStage::show_marks(const SceneMarks& marks) {
  for (Parts::Pane& pane : parts_->panes) pane.marks.show(marks);
}

void SceneStage::keep_picture(bool keep) {
  for (Parts::Pane& pane : parts_->panes) {
    pane.scene->SetPreserveColorBuffer(keep);
    pane.scene->SetPreserveDepthBuffer(keep);
  }
}

void SceneStage::on_motion(std::function<void(bool)> listener) { parts_->motion_listener = std::move(listener); }

void SceneStage::on_frame(std::function<void(double)> listener) { parts_->frame_listener = std::move(listener); }

void SceneStage::on_drawn(std::function<void()> listener) { parts_->drawn_listener = std::move(listener); }

void SceneStage::set_forward(double azimuth_rad) { parts_->forward_rad = azimuth_rad; }

}  // namespace remount::scene
