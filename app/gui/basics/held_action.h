// An action that is done again and again while its key is held.
#pragma once

#include <QElapsedTimer>
#include <QObject>
#include <QTimer>
#include <functional>

class QAction;

namespace remount::gui {

/// In the place of the keyboard's own repetition, whose events queue up where the action takes longer than their period
/// and run on after the key is let go. The action goes on when `may_act` says that its last effect is seen.
class HeldAction : public QObject {
  Q_OBJECT
 public:
  /// Lives as long as the action.
  HeldAction(QAction& action, std::function<bool()> may_act);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void act_if_held();

  QAction& action_;
  std::function<bool()> may_act_;
  QElapsedTimer since_repeat_;  // the last event that the keyboard sent for a held key
  QTimer pulse_;
};

}  // namespace remount::gui
