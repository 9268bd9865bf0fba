#include "app/gui/shell/full_screen.h"

#include <QDockWidget>
#include <QMainWindow>
#include <QMenuBar>
#include <QStatusBar>
#include <QTabWidget>
#include <QToolBar>

namespace remount::gui {

FullScreen::FullScreen(QMainWindow& window) : QObject(&window), window_(window) {}

void FullScreen::set(bool on) {
  if (on == on_) return;
  on_ = on;
  if (on) {
    layout_ = window_.saveState();
    was_maximized_ = window_.isMaximized();
    hidden_.clear();
    QList<QWidget*> around;
    for (auto* dock : window_.findChildren<QDockWidget*>()) around << dock;
    for (auto* bar : window_.findChildren<QToolBar*>()) around << bar;
    around << window_.statusBar();
    for (QWidget* widget : around)
      if (widget->isVisible()) {
        hidden_.emplace_back(widget);
        widget->hide();
      }
    window_.menuBar()->setMaximumHeight(0);
    window_.showFullScreen();
    return;
  }
  window_.menuBar()->setMaximumHeight(QWIDGETSIZE_MAX);
  for (const QPointer<QWidget>& widget : hidden_)
    if (widget) widget->show();
  was_maximized_ ? window_.showMaximized() : window_.showNormal();
  window_.restoreState(layout_);
}

}  // namespace remount::gui
