// Which pair is looked at.
#pragma once

#include <optional>

#include "app/gui/workbench/outcome.h"

namespace remount::gui {

/// Holds the selected pair and reads its clouds; those of a pair that is no longer selected are never told.
class Selection : public WorkbenchPart {
  Q_OBJECT
 public:
  Selection(const Desk& desk, Outcome& outcome);
  std::optional<motion::PairIndex> pair() const { return pair_; }
  void select(std::optional<motion::PairIndex> pair);
  /// Although it may be the one that was selected before: what it belongs to is another.
  void select_anew(std::optional<motion::PairIndex> pair);

 signals:
  void changed(std::optional<motion::PairIndex> pair);
  void clouds_loading(motion::PairIndex pair);
  void clouds_loaded(motion::PairIndex pair, gui::CloudsPtr clouds);
  void clouds_failed(motion::PairIndex pair, const QString& why);

 private:
  void load_clouds();
  Outcome& outcome_;
  std::optional<motion::PairIndex> pair_;
  int job_ = 0;
};

}  // namespace remount::gui
