// Which pair is looked at.
#pragma once

#include <optional>

#include "app/gui/workbench/outcome.h"

namespace remount::gui {

class Selection : public WorkbenchPart {
  Q_OBJECT
 public:
  Selection(const Desk& desk, Outcome& outcome) : WorkbenchPart(desk), outcome_(outcome) {}
  std::optional<motion::PairIndex> pair() const { return pair_; }
  void select(std::optional<motion::PairIndex> pair);
  /// Although it may be the one that was selected before: what it belongs to is another.
  void select_anew(std::optional<motion::PairIndex> pair);

 signals:
  void changed(std::optional<motion::PairIndex> pair);

 private:
  Outcome& outcome_;
  std::optional<motion::PairIndex> pair_;
};

}  // namespace remount::gui
