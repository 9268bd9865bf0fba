// Edits that can be undone.
#pragma once

#include <QUndoCommand>

#include "app/gui/workbench.h"

namespace remount {

/// "undo: reject pair 12".
QString undone(const QString& step);

class DecisionCommand : public QUndoCommand {
 public:
  DecisionCommand(Workbench& workbench, const QString& text, std::vector<PairDecision> before,
                  std::vector<PairDecision> after);
  void undo() override { workbench_.apply_decisions(before_, undone(text())); }
  void redo() override { workbench_.apply_decisions(after_, text()); }
  int id() const override { return 3; }
  /// Saying why right after rejecting is one edit.
  bool mergeWith(const QUndoCommand* other) override;

 private:
  Workbench& workbench_;
  std::vector<PairDecision> before_, after_;
};

/// `field` names what was edited ("range.x_min_m"): turning one knob step by step is one edit.
class SettingsCommand : public QUndoCommand {
 public:
  SettingsCommand(Workbench& workbench, const QString& text, const QString& field, const Settings& after);
  void undo() override { workbench_.apply_settings(before_, undone(text())); }
  void redo() override { workbench_.apply_settings(after_, text()); }
  int id() const override { return 1; }
  bool mergeWith(const QUndoCommand* other) override;

 private:
  Workbench& workbench_;
  QString field_;
  Settings before_, after_;
};

/// Another session of the same recording takes the place of one; its result goes and comes back with it.
class TopicsCommand : public QUndoCommand {
 public:
  TopicsCommand(Workbench& workbench, std::shared_ptr<const Session> before, std::shared_ptr<const Session> after);
  void undo() override { workbench_.apply_session(after_, before_, calibrated_); }
  void redo() override { workbench_.apply_session(before_, after_, nullptr); }

 private:
  Workbench& workbench_;
  std::shared_ptr<const Session> before_, after_;
  std::shared_ptr<const Workbench::Calibrated> calibrated_;  ///< with `before_`
};

class NominalCommand : public QUndoCommand {
 public:
  NominalCommand(Workbench& workbench, const QString& text, const std::optional<RigidTransform>& after);
  void undo() override { workbench_.apply_nominal(before_); }
  void redo() override { workbench_.apply_nominal(after_); }
  int id() const override { return 2; }
  bool mergeWith(const QUndoCommand* other) override;

 private:
  Workbench& workbench_;
  std::optional<RigidTransform> before_, after_;
};

}  // namespace remount
