// The map check of a new X.
#pragma once

#include <QTimer>

#include "app/gui/workbench/outcome.h"

namespace remount::gui {

/// Compares the map under a result that has none of its own, in the background and after a pause: while the user goes
/// on deciding, the map is not read.
class MapChecks : public WorkbenchPart {
  Q_OBJECT
 public:
  MapChecks(const Desk& desk, Outcome& outcome);
  /// The map check of a new X is under way, or begins soon.
  bool checking() const { return pause_.isActive() || desk_.activity.running(Activity::Kind::CheckingMap); }
  const QString& failure() const { return failure_; }  ///< why the last check came to nothing
  void begin_soon();                                   ///< the outcome is another, or what stood in the way is gone
  void stop();                                         ///< another X is on its way

 private:
  void begin();
  void take(const OutputPtr& checked);
  Outcome& outcome_;
  QTimer pause_;
  QString failure_;
};

}  // namespace remount::gui
