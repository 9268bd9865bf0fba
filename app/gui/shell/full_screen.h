// The view alone on the whole screen, and back.
#pragma once

#include <QByteArray>
#include <QObject>
#include <QPointer>
#include <vector>

class QMainWindow;
class QWidget;

namespace remount::gui {

/// Hides docks, tool bars and status bar. Keys stay: a menu bar that is hidden would take its shortcuts with it, one
/// without height does not.
class FullScreen : public QObject {
  Q_OBJECT
 public:
  explicit FullScreen(QMainWindow& window);
  bool on() const { return on_; }
  void set(bool on);

 private:
  QMainWindow& window_;
  std::vector<QPointer<QWidget>> hidden_;
  QByteArray layout_;
  bool on_ = false, was_maximized_ = false;
};

}  // namespace remount::gui
