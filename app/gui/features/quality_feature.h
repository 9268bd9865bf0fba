// Whether the result is good: obstacles, sharpness of the map, sessions against each other.
#pragma once

#include "app/gui/shell/feature.h"

class QDockWidget;

namespace remount::widgets {
class QualityView;
}  // namespace remount::widgets

namespace remount::gui {

class QualityController;

class QualityFeature : public Feature {
  Q_OBJECT
 public:
  explicit QualityFeature(MainWindow& window);
  std::vector<TurnQueue::Piece> show_output_later() override;
  void show_state() override;

 private:
  void show_quality();
  widgets::QualityView* quality_;
  QDockWidget* dock_;
  QualityController* checks_;
};

}  // namespace remount::gui
