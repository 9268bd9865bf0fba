// Help for the panel that has the focus, and what the program is.
#pragma once

#include "app/gui/shell/feature.h"

namespace remount {

class HelpWindow;

class HelpFeature : public Feature {
  Q_OBJECT
 public:
  explicit HelpFeature(MainWindow& window);

 private:
  void show_help();
  void show_about();
  HelpWindow* help_ = nullptr;
};

}  // namespace remount
