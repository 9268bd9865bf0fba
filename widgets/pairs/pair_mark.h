// What somebody noted about a pair.
#pragma once

#include <QString>
#include <memory>
#include <vector>

namespace remount::widgets {

struct PairMark {
  bool seen = false, flagged = false;
  QString comment;
  bool empty() const { return !seen && !flagged && comment.isEmpty(); }
};
/// Of each pair; null: of none.
using PairMarksPtr = std::shared_ptr<const std::vector<PairMark>>;

}  // namespace remount::widgets
