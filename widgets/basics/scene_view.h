// What the 3-D views of the window have in common: canvas, buttons, message, picking and measuring.
#pragma once

#include <QImage>
#include <QPoint>
#include <QWidget>
#include <optional>
#include <vector>

#include "widgets/scene/scene_stage.h"

class QHBoxLayout;
class QMenu;
class QLabel;
class QTimer;
class QStackedLayout;
class QToolButton;
class QVBoxLayout;
class QVTKOpenGLNativeWidget;

namespace remount::widgets {

class ScaleBar;

class SceneView : public QWidget {
  Q_OBJECT
 public:
  ~SceneView() override;

  void show_message(const QString& text);  ///< instead of a scene: loading, nothing selected, why it failed
  bool shows_scene() const;
  bool has_gl() const { return canvas_ != nullptr; }
  QWidget* canvas() const;  ///< takes the keys; null without GL
  void look(scene::StandardView view);
  /// Azimuth of the vehicle's forward axis in the axes that are shown, rad.
  void set_forward(double azimuth_rad);
  /// The buttons' menu of views: the actions that the window has for them, with their keys.
  void set_view_actions(const QList<QAction*>& actions);
  /// What is far as large as what is near.
  void set_parallel(bool on);
  bool parallel() const;
  QImage picture() const;  ///< of the scene, as it is shown
  void set_eye_dome(bool on);
  bool eye_dome() const;
  /// While measuring, two clicks measure the distance between two points; otherwise a click tells one point.
  void set_measuring(bool on);
  bool measuring() const;
  /// What a click at this place of the canvas does.
  void click(const QPointF& place_in_canvas);
  QString readout() const;  ///< what the last click told, in words
  void render();
  /// Where a point of the view is on the canvas; for tests.
  QPointF place_of(const Eigen::Vector3d& point_in_view) const;

 protected:
  struct Pick {
    Eigen::Vector3d point_in_view;
    QString words;  ///< coordinates with their frame, and what else is known
  };
  SceneView(const QString& accessible_name, QWidget* parent);
  /// To be called once by the constructor of a derived class; builds the buttons.
  void set_stage(scene::SceneStage& stage);
  virtual std::optional<Pick> pick(const scene::PickRay& ray) const = 0;
  virtual QString axes_in_words() const = 0;           ///< of the frame in which the scene is shown
  virtual void pixel_ratio_changed(double ratio) = 0;  ///< also when points become larger for other reasons
  virtual void palette_changed();
  /// The mouse begins to move the camera; it has rested for a moment.
  virtual void motion_changed(bool /*moving*/) {}
  virtual void size_changed() {}
  virtual void view_changed() {}  ///< by a key or button, not by the mouse
  /// What the menu of a right click holds beside views and pictures; `picked`: the point that was clicked on.
  virtual void fill_menu(QMenu& /*menu*/, const std::optional<Pick>& /*picked*/) {}

  QHBoxLayout* add_row();  ///< of buttons above the scene
  QToolButton* add_button(QHBoxLayout* row, const QString& text, const QString& help, bool checkable);
  void add_shading_button(QHBoxLayout* row);  ///< where there are points: lines are not shaded
  void add_common_buttons(QHBoxLayout* row);
  void show_scene();
  /// What is rendered next is thin where the whole would be slow; the whole follows when nothing else is asked for.
  void draw_quickly();
  void enable_buttons(bool enable);
  void add_below(QWidget* widget);
  void clear_marks();

  void changeEvent(QEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  bool handle_canvas(QEvent* event);
  std::optional<Pick> pick_at(const QPointF& place_in_canvas) const;
  void show_menu(const QPoint& place_in_canvas);
  void save_picture();
  void place_scale();
  void say(const QString& text);
  void place_readout();
  void show_picked();

  scene::SceneStage* stage_ = nullptr;
  QVTKOpenGLNativeWidget* canvas_ = nullptr;
  QVBoxLayout* column_;
  QVBoxLayout* rows_layout_;
  QWidget* rows_;
  QLabel *message_, *readout_;
  QStackedLayout* stack_;
  QToolButton *measure_ = nullptr, *eye_dome_ = nullptr, *views_ = nullptr;
  std::vector<Pick> picked_;
  QPoint pressed_at_;
  bool pressed_ = false, pressed_right_ = false;
  ScaleBar* scale_;
  QList<QAction*> view_actions_;
  QTimer* rest_;  // after the last motion
  QString gl_reason_;
};

}  // namespace remount::widgets
