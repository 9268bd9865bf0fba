// Everything that was said, in a dock.
#pragma once

#include "app/gui/shell/feature.h"

namespace remount {

class LogPanel;

class LogFeature : public Feature {
  Q_OBJECT
 public:
  explicit LogFeature(MainWindow& window);
  std::unique_ptr<Kept> hand_over() override;
  void take_over(Kept* kept) override;

 private:
  LogPanel* log_;
};

}  // namespace remount
