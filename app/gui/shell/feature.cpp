#include "app/gui/shell/feature.h"

#include "app/gui/shell/main_window.h"

namespace remount::gui {

Feature::Feature(MainWindow& window) : window_(window), workbench_(window.workbench()) {}
Feature::~Feature() = default;

bool Feature::may_close(const std::function<void()>&) { return true; }

}  // namespace remount::gui
