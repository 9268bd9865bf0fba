// The accumulated map, beside the pair.
#pragma once

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
  void show_candidate(int candidate);  ///< by its place in the result's list; -1 for none
  void show_map(MapX x);

 private:
  MapView* view_;
  MapController* maps_;
};

}  // namespace remount
