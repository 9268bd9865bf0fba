// Whether the result is good: obstacles, sharpness of the map, sessions against each other.
#pragma once

#include "app/gui/shell/feature.h"

class QDockWidget;

namespace remount {

class QualityController;
class QualityView;

class QualityFeature : public Feature {
  Q_OBJECT
 public:
  explicit QualityFeature(MainWindow& window);
  std::vector<TurnQueue::Piece> show_output_later() override;
  void show_state() override;

 private:
  void show_quality();
  QualityView* quality_;
  QDockWidget* dock_;
  QualityController* checks_;
};

}  // namespace remount
