// How the drives look, with their pairs.
#pragma once

#include "app/gui/shell/feature.h"

namespace remount::widgets {
class DrivePanel;
}  // namespace remount::widgets

namespace remount::gui {

class DriveFeature : public Feature {
  Q_OBJECT
 public:
  explicit DriveFeature(MainWindow& window);
  std::vector<TurnQueue::Piece> show_output_later() override;

 private:
  widgets::DrivePanel* drive_;
};

}  // namespace remount::gui
