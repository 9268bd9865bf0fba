// F1: help for the panel that has the focus.
#include <QApplication>
#include <QCursor>
#include <QDir>
#include <QDockWidget>

#include "app/gui/basics/language.h"
#include "app/gui/shell/main_window.h"
#include "widgets/map/map_view.h"
#include "widgets/pairs/pair_view.h"
#include "widgets/shell/help_window.h"

namespace remount {

QString MainWindow::help_page_of(const QWidget* widget) const {
  static const std::map<QString, QString> kPages{
      {"setup", "setup"},           {"pairs", "pairs"},   {"errors", "errors"},
      {"candidates", "candidates"}, {"result", "result"}, {"quality", "quality"},
      {"methods", "methods"},       {"drive", "drive"},   {"log", "log"}};
  for (; widget; widget = widget->parentWidget()) {
    if (widget == pair_view_) return QStringLiteral("view");
    if (widget == map_view_) return QStringLiteral("map");
    const auto page = qobject_cast<const QDockWidget*>(widget) ? kPages.find(widget->objectName()) : kPages.end();
    if (page != kPages.end()) return page->second;
  }
  return workbench_.sessions().all().empty() ? QStringLiteral("start") : QStringLiteral("projects");
}

void MainWindow::show_help() {
  QString page = help_page_of(QApplication::focusWidget());
  // A click on a tab or a label gives no panel the keyboard: then it is what lies under the pointer.
  if (page == help_page_of(nullptr) && !workbench_.sessions().all().empty())
    page = help_page_of(QApplication::widgetAt(QCursor::pos()));
  if (!help_) {
    const QString own = ":/help/" + spoken_language();
    help_ = new HelpWindow(QDir(own).exists() ? own : QStringLiteral(":/help/en"), this);
  }
  help_->show_page(page);
  help_->show();
  help_->raise();
  help_->activateWindow();
}

}  // namespace remount
