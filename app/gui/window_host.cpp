#include "app/gui/window_host.h"

#include <QTimer>

#include "app/gui/language.h"

namespace remount {

WindowHost::WindowHost(Workbench& workbench, QObject* parent)
    : QObject(parent), workbench_(workbench), window_(std::make_unique<MainWindow>(workbench)) {
  connect_window();
}

void WindowHost::connect_window() {
  // From the loop: the menu that asks belongs to the window that goes.
  connect(window_.get(), &MainWindow::language_requested, this,
          [this](const QString& code) { QTimer::singleShot(0, this, [this, code] { change_language(code); }); });
}

void WindowHost::change_language(const QString& code) {
  if (code == spoken_language()) return;
  WindowHandover handover = window_->hand_over();
  speak(code, true);
  auto next = std::make_unique<MainWindow>(workbench_);
  next->take_over(std::move(handover));
  const bool visible = window_->isVisible();
  if (visible) next->show();
  window_->hide();
  window_ = std::move(next);
  connect_window();
  workbench_.announce();
  if (visible) window_->activateWindow();
  emit window_changed();
}

}  // namespace remount
