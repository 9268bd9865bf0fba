// The two scans of the selected pair.
#pragma once

#include <optional>

#include "app/gui/shell/feature.h"
#include "app/gui/workbench/calibrated.h"
#include "widgets/scene/pair_scene_data.h"

class QAction;

namespace remount::widgets {
class PairView;
}  // namespace remount::widgets

namespace remount::gui {

class SceneController;

class PairViewFeature : public Feature {
  Q_OBJECT
 public:
  explicit PairViewFeature(MainWindow& window);
  std::vector<TurnQueue::Piece> show_output_later() override;
  void show_state() override;
  /// By its place in the result's list; which is shown now, nothing for the result.
  std::optional<calibration::CandidateIndex> show_candidate(calibration::CandidateIndex candidate);
  /// Clouds of two LiDARs, until a pair is selected.
  void show_cross_pair(const QString& caption, const CloudsPtr& clouds, const scene::PairTransforms& transforms);

 private:
  void make_review();
  void make_scene();
  void connect_selection();
  void show_obstacles();
  void show_selected(std::optional<motion::PairIndex> pair);
  void show_scans(motion::PairIndex pair, const scene::PairSceneDataPtr& data);
  QString scan_name_of(motion::KeyframeIndex keyframe) const;
  QString caption(motion::PairIndex pair) const;

  widgets::PairView* view_;
  SceneController* scenes_ = nullptr;
  QAction* obstacles_ = nullptr;
  CloudsPtr shown_clouds_;  // of the selected pair
};

}  // namespace remount::gui
