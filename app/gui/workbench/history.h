// What can be undone.
#pragma once

#include <QUndoStack>

namespace remount::gui {

/// An edit whose name is known in every language, for it may be undone after another was chosen.
class NamedEdit : public QUndoCommand {
 public:
  virtual QString name() const = 0;
};

/// Holds the steps. The edits themselves (edit_commands.h) call the parts that they change; what a step holds of
/// calibrations and sessions is shared with what is there now.
class History {
 public:
  static constexpr int kOpening = 4;  ///< id of the edits that merely open sessions

  History() {
    constexpr int kMostSteps = 1000;  // those that hold calibrations and closed sessions cost memory
    stack_.setUndoLimit(kMostSteps);
  }
  QUndoStack& stack() { return stack_; }
  void push(QUndoCommand* edit) { stack_.push(edit); }
  void clear() { stack_.clear(); }
  bool can_undo() const { return stack_.canUndo(); }
  bool has_edits() const;  ///< that can be undone, beside sessions that were opened
  void name_edits_anew();  ///< in the language of now, before a window shows them

 private:
  QUndoStack stack_;
};

}  // namespace remount::gui
