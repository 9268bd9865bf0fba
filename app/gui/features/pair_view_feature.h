// The two scans of the selected pair.
#pragma once

#include <optional>

#include "app/gui/shell/feature.h"
#include "app/gui/workbench/calibrated.h"

class QAction;

namespace remount {

class PairView;
class SceneController;

class PairViewFeature : public Feature {
  Q_OBJECT
 public:
  explicit PairViewFeature(MainWindow& window);
  std::vector<TurnQueue::Piece> show_output_later() override;
  void show_state() override;
  /// By its place in the result's list; which is shown now, nothing for the result.
  std::optional<CandidateIndex> show_candidate(CandidateIndex candidate);

 private:
  void make_review();
  void make_scene();
  void connect_selection();
  void show_obstacles();
  void show_selected(std::optional<PairIndex> pair);
  void show_clouds(PairIndex pair, const CloudsPtr& clouds);
  QString scan_name_of(KeyframeIndex keyframe) const;
  QString caption(PairIndex pair) const;

  PairView* view_;
  SceneController* scenes_ = nullptr;
  QAction* obstacles_ = nullptr;
  CloudsPtr shown_clouds_;  // of the selected pair
};

}  // namespace remount
