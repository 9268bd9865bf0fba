// Owns the window and makes another one in its place where the language changes: every text is then made anew, by the
// code that made it the first time.
#pragma once

#include <QObject>
#include <memory>

#include "app/gui/shell/main_window.h"

namespace remount::gui {

class WindowHost : public QObject {
  Q_OBJECT
 public:
  explicit WindowHost(Workbench& workbench, QObject* parent = nullptr);
  MainWindow& window() { return *window_; }
  /// The work, the log and the layout stay; open dialogs close. A report that is being made is finished first, in the
  /// language in which it was begun.
  void change_language(const QString& code);

 signals:
  void window_changed();

 private:
  void connect_window();
  class ReportMaker& report();  // of the window
  Workbench& workbench_;
  std::unique_ptr<MainWindow> window_;
  QString wanted_;  // language; empty: as it is
};

}  // namespace remount::gui
