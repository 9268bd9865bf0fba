// How the drives look, with their pairs.
#pragma once

#include "app/gui/shell/feature.h"

namespace remount {

class DrivePanel;

class DriveFeature : public Feature {
  Q_OBJECT
 public:
  explicit DriveFeature(MainWindow& window);
  std::vector<TurnQueue::Piece> show_output_later() override;

 private:
  DrivePanel* drive_;
};

}  // namespace remount
