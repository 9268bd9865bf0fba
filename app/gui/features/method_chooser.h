// Which method the next calibration uses.
#pragma once

#include <QComboBox>

#include "app/gui/workbench/workbench.h"

namespace remount::gui {

/// Lists the methods with what they need; edits the settings as the options form does.
class MethodChooser : public QComboBox {
  Q_OBJECT
 public:
  explicit MethodChooser(Workbench& workbench);

 private:
  void show_choice();
  Workbench& workbench_;
};

}  // namespace remount::gui
