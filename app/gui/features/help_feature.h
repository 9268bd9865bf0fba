// Help for the panel that has the focus, and what the program is.
#pragma once

#include "app/gui/shell/feature.h"

namespace remount::widgets {
class HelpWindow;
}  // namespace remount::widgets

namespace remount::gui {

class HelpFeature : public Feature {
  Q_OBJECT
 public:
  explicit HelpFeature(MainWindow& window);
  void show_page(const QString& page);  ///< by its name in resources/help

 private:
  void show_help();
  void show_about();
  widgets::HelpWindow* help_ = nullptr;
};

}  // namespace remount::gui
