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

inline constexpr int kWorkspaces = 2;

/// How docks stand in each; empty: it was never left.
struct WorkspaceStates {
  Workspace now = Workspace::All;
  std::array<QByteArray, kWorkspaces> states;
};

/// What the user changes in one is remembered for it.
class Workspaces : public QObject {
  Q_OBJECT
 public:
  Workspaces(QMainWindow& window, Docks& docks);
  void go_to(Workspace workspace);
  /// As they are at first.
  void reset();
  void restore();               ///< what is remembered, and the one that was there last
  void remember();              ///< for the next start
  WorkspaceStates hand_over();  ///< to a window that takes the place of this one
  void take_over(const WorkspaceStates& states);

 private:
  void arrange_review();

  QMainWindow& window_;
  Docks& docks_;
  QByteArray first_;  // of all docks, before the user arranged any
  WorkspaceStates kept_;
};

}  // namespace remount::gui
