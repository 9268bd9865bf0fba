// The ways that a method drew (trajectories, fixes, the circle of a turn), in three dimensions.
#pragma once

#include <vector>

#include "algorithms/calibration/method_details.h"
#include "widgets/basics/rows.h"
#include "widgets/basics/scene_view.h"
#include "widgets/scene/path_scene.h"

class QComboBox;
class QLabel;

namespace remount::widgets {

class PathView : public SceneView {
  Q_OBJECT
 public:
  explicit PathView(QWidget* parent = nullptr);
  /// Those of the plots that have heights; `otherwise` is said where none has.
  void show_plots(const std::vector<calibration::Plot>& plots, const QString& otherwise);
  int plot_count() const { return qt_count(plots_.size()); }
  const scene::PathScene& scene() const { return scene_; }

 protected:
  std::optional<Pick> pick(const scene::PickRay& ray) const override;
  QString axes_in_words() const override;
  void pixel_ratio_changed(double ratio) override;
  void palette_changed() override;
  void showEvent(QShowEvent* event) override;

 private:
  void make_buttons();
  void show_chosen();
  void draw();
  const calibration::Plot* chosen() const;

  scene::PathScene scene_;
  std::vector<calibration::Plot> plots_;
  QComboBox* choice_ = nullptr;
  QLabel* legend_;
};

}  // namespace remount::widgets
