// What every 3-D view has: one or two pictures with one camera, the mouse, axes, light, marks, and standard views.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "algorithms/geometry/rigid_transform.h"
#include "widgets/scene/framing.h"
#include "widgets/scene/picking.h"

class vtkRenderer;
class vtkRenderWindow;

namespace remount::scene {

/// Fit keeps the direction of the view. Left looks at the vehicle's left side, front at its front. What is seen along
/// an axis is seen in parallel, so that lengths can be compared; the isometric view is in perspective.
enum class StandardView { Fit, Top, Front, Left, Isometric };

/// Points that the user marked, in the frame in which the scene is shown, m; a line joins two of them.
struct SceneMarks {
  std::vector<Eigen::Vector3d> points_in_view;
  std::string label;  ///< at the last point; of a line in its middle
};

/// Owns the renderers, not what is in them. All calls on the thread that owns the render window.
class SceneStage {
 public:
  static constexpr int kPanes = 2;

  SceneStage();
  ~SceneStage();
  SceneStage(const SceneStage&) = delete;
  SceneStage& operator=(const SceneStage&) = delete;

  /// Adds the renderers and the mouse style. The window must have an interactor.
  void attach(vtkRenderWindow& window);
  vtkRenderer& pane(int index);
  vtkRenderer& overlay(int index);  ///< for lines: shown with the depth of the pane, and not shaded
  /// One picture, or two side by side. Their camera is the same.
  void show_panes(int count);
  int shown_panes() const;
  void set_dark(bool dark);
  /// Eye-dome lighting: edges of depth are darkened, which shows shapes where points have no light of their own.
  void set_eye_dome(bool on);
  bool eye_dome() const;
  /// What the views look at. Also bounds the depth that is drawn, so that stray points cannot use it up.
  void frame(const Framing& framing);
  void look(StandardView view);
  /// Parallel: what is far is as large as what is near.
  void set_parallel(bool on);
  bool parallel() const;
  /// Orbits and zooms about this point from now on.
  void centre_on(const Eigen::Vector3d& point_in_view);
  /// Of the window, in the distance of what is looked at; everywhere where the view is parallel.
  double metres_per_pixel() const;
  /// The ray through a pixel of the window, counted from the lower left; nothing outside the pictures.
  std::optional<PickRay> ray_at(double x_px, double y_px) const;
  /// Where a point of the view is on the window; for tests and for labels.
  Eigen::Vector2d pixel_of(const Eigen::Vector3d& point_in_view, int pane = 0) const;
  void show_marks(const SceneMarks& marks);
  /// The next picture is drawn over what is there, colours and depth, instead of over the background.
  void keep_picture(bool keep);
  /// Called when the mouse begins and ends to move the camera.
  void on_motion(std::function<void(bool moving)> listener);
  /// Called after each frame with the seconds that it took, the graphics processor's work included.
  void on_frame(std::function<void(double seconds)> listener);
  /// Called after each frame, whoever drew it.
  void on_drawn(std::function<void()> listener);
  /// Azimuth of the vehicle's forward axis in the view, rad: what "front" and "left" mean.
  void set_forward(double azimuth_rad);

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace remount::scene
