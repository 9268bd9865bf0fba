// The accumulated map, beside the pair.
#pragma once

#include <optional>

#include "algorithms/calibration/calibration_result.h"
#include "app/gui/shell/feature.h"

namespace remount::widgets {
class MapView;
enum class MapX;
}  // namespace remount::widgets

namespace remount::gui {

class MapController;

class MapFeature : public Feature {
  Q_OBJECT
 public:
  explicit MapFeature(MainWindow& window);
  std::vector<TurnQueue::Piece> show_output_later() override;
  void show_candidate(std::optional<calibration::CandidateIndex> candidate);
  void show_map(widgets::MapX x);

 private:
  widgets::MapView* view_;
  MapController* maps_;
};

}  // namespace remount::gui
