// Which pair is looked at.
#pragma once

#include "app/gui/workbench/outcome.h"

namespace remount {

/// Holds the selected pair and reads its clouds; those of a pair that is no longer selected are never told.
class Selection : public WorkbenchPart {
  Q_OBJECT
 public:
  Selection(const Desk& desk, Outcome& outcome);
  int pair() const { return pair_; }  ///< -1 for none
  void select(int pair);
  /// Although it may be the one that was selected before: what it belongs to is another.
  void select_anew(int pair);

 signals:
  void changed(int pair);
  void clouds_loading(int pair);
  void clouds_loaded(int pair, remount::CloudsPtr clouds);
  void clouds_failed(int pair, const QString& why);

 private:
  void load_clouds();
  Outcome& outcome_;
  int pair_ = -1, job_ = 0;
};

}  // namespace remount
