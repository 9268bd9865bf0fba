// Which docks stand around the views, by what is being done.
#pragma once

#include <QMainWindow>
#include <array>

#include "app/gui/shell/docks.h"

namespace remount::gui {

enum class Workspace {
  All,     ///< every dock
  Review,  ///< what pairs are judged by; the view has the rest of the window
};

/// What the user changes in one is remembered for it.
class Workspaces : public QObject {
  Q_OBJECT
 public:
  Workspaces(QMainWindow& window, Docks& docks);
  Workspace now() const { return now_; }
  void go_to(Workspace workspace);
  /// As they are at first.
  void reset();
  void restore();   ///< what is remembered, and the one that was there last
  void remember();  ///< for the next start

 private:
  void arrange_review();

  static constexpr int kCount = 2;
  QMainWindow& window_;
  Docks& docks_;
  Workspace now_ = Workspace::All;
  QByteArray first_;                       // of all docks, before the user arranged any
  std::array<QByteArray, kCount> states_;  // empty: never left
};

}  // namespace remount::gui
