// The window's keys that fields would take: undo, redo and export.
#pragma once

#include <QObject>

namespace remount::gui {

/// Fields take these keys for what is typed in them, whether there is anything to take back or not. This leaves them to
/// the window's actions where the field holds nothing that is typed and not taken over yet; Ctrl+E always.
class UndoKeys : public QObject {
 public:
  explicit UndoKeys(QObject* parent);  ///< for all fields of the application
  bool eventFilter(QObject* watched, QEvent* event) override;
};

}  // namespace remount::gui
