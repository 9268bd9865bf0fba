// Everything that was said, in a dock.
#pragma once

#include "app/gui/shell/feature.h"

namespace remount::widgets {
class LogPanel;
}  // namespace remount::widgets

namespace remount::gui {

class LogFeature : public Feature {
  Q_OBJECT
 public:
  explicit LogFeature(MainWindow& window);
  std::unique_ptr<Kept> hand_over() override;
  void take_over(Kept* kept) override;

 private:
  widgets::LogPanel* log_;
};

}  // namespace remount::gui
