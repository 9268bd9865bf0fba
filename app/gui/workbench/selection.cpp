#include "app/gui/workbench/selection.h"

namespace remount::gui {

void Selection::select(std::optional<motion::PairIndex> pair) {
  const OutputPtr output = outcome_.output();
  if (!output || (pair && *pair >= output->pairs.size())) pair.reset();
  if (pair == pair_ && pair) return;
  pair_ = pair;
  emit changed(pair);
}

void Selection::select_anew(std::optional<motion::PairIndex> pair) {
  pair_.reset();
  select(pair);
}

}  // namespace remount::gui
