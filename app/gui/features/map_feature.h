// The accumulated map, beside the pair.
#pragma once

#include <optional>

#include "algorithms/calibration/calibration_result.h"
#include "app/gui/shell/feature.h"

namespace remount {

class MapController;
class MapView;
enum class MapX;

class MapFeature : public Feature {
  Q_OBJECT
 public:
  explicit MapFeature(MainWindow& window);
  std::vector<TurnQueue::Piece> show_output_later() override;
  void show_candidate(std::optional<CandidateIndex> candidate);
  void show_map(MapX x);

 private:
  MapView* view_;
  MapController* maps_;
};

}  // namespace remount
