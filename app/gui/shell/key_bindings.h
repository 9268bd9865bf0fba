// Actions whose keys the user may change.
#pragma once

#include <QMainWindow>
#include <vector>

#include "widgets/shell/keys_dialog.h"

namespace remount::gui {

/// Holds them under the names by which their keys are remembered from one start to the next.
class KeyBindings : public QObject {
  Q_OBJECT
 public:
  explicit KeyBindings(QMainWindow& window);
  /// Its present key is the standard one.
  QAction* bind(const QString& id, QAction* action);
  void restore();  ///< those that are remembered, once all are bound
  void ask();

 private:
  struct Bound {
    QString id;
    QAction* action;
    QKeySequence standard;
  };
  std::vector<widgets::KeyBinding> list() const;  ///< with the other keys of the window, which stay
  void apply(const std::vector<widgets::KeyBinding>& bindings);

  QMainWindow& window_;
  std::vector<Bound> bound_;
};

}  // namespace remount::gui
