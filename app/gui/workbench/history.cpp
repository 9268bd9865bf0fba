#include "app/gui/workbench/history.h"

namespace remount::gui {

bool History::has_edits() const {
  for (int i = 0; i < stack_.index(); ++i)
    if (stack_.command(i)->id() != kOpening) return true;
  return false;
}

void History::name_edits_anew() {
  for (int i = 0; i < stack_.count(); ++i)
    if (const auto* edit = dynamic_cast<const NamedEdit*>(stack_.command(i)))
      const_cast<NamedEdit*>(edit)->setText(edit->name());  // the stack gives out what it holds as const alone
}

}  // namespace remount::gui
