// Which pair is looked at.
#pragma once

#include <optional>

#include "app/gui/workbench/outcome.h"

namespace remount {

/// Holds the selected pair and reads its clouds; those of a pair that is no longer selected are never told.
class Selection : public WorkbenchPart {
  Q_OBJECT
 public:
  Selection(const Desk& desk, Outcome& outcome);
  std::optional<PairIndex> pair() const { return pair_; }
  void select(std::optional<PairIndex> pair);
  /// Although it may be the one that was selected before: what it belongs to is another.
  void select_anew(std::optional<PairIndex> pair);

 signals:
  void changed(std::optional<remount::PairIndex> pair);
  void clouds_loading(remount::PairIndex pair);
  void clouds_loaded(remount::PairIndex pair, remount::CloudsPtr clouds);
  void clouds_failed(remount::PairIndex pair, const QString& why);

 private:
  void load_clouds();
  Outcome& outcome_;
  std::optional<PairIndex> pair_;
  int job_ = 0;
};

}  // namespace remount
