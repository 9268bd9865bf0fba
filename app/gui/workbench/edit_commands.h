// Edits that can be undone.
#pragma once

#include <QUndoCommand>

#include "app/gui/workbench/workbench.h"

namespace remount {

/// "undo: reject pair 12".
QString undone(const QString& step);

/// An edit whose name is known in every language, for it may be undone after another was chosen.
class NamedEdit : public QUndoCommand {
 public:
  virtual QString name() const = 0;
};

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

/// A calibration that took the place of `before`. Made when it is there already. `method`: its id.
class CalibrationCommand : public NamedEdit {
 public:
  CalibrationCommand(Workbench& workbench, std::string method, Workbench::CalibratedPtr before);
  QString name() const override;
  void undo() override;
  void redo() override;

 private:
  Workbench& workbench_;
  std::string method_;
  Workbench::CalibratedPtr before_, after_;  ///< after: once it was undone
};

/// Another session of the same recording takes the place of one; its result goes and comes back with it.
class TopicsCommand : public QUndoCommand {
 public:
  TopicsCommand(Workbench& workbench, std::shared_ptr<const Session> before, std::shared_ptr<const Session> after);
  void undo() override;
  void redo() override;

 private:
  Workbench& workbench_;
  std::shared_ptr<const Session> before_, after_;
  Workbench::CalibratedPtr calibrated_;  ///< with `before_`
  std::optional<RigidTransform> nominal_before_, nominal_after_;
  bool undone_ = false;
};

/// Sessions are opened, and with them the nominal that they bring where there is none.
class OpeningCommand : public NamedEdit {
 public:
  static constexpr int kId = 4;
  OpeningCommand(Workbench& workbench, std::vector<std::shared_ptr<const Session>> sessions);
  QString name() const override;
  void undo() override;
  void redo() override;
  int id() const override { return kId; }

 private:
  Workbench& workbench_;
  std::vector<std::shared_ptr<const Session>> sessions_;
  std::optional<RigidTransform> nominal_before_, nominal_after_;
};

/// A session is closed; what was calibrated from it goes and comes back with it.
class RemovalCommand : public QUndoCommand {
 public:
  RemovalCommand(Workbench& workbench, std::shared_ptr<const Session> session, std::ptrdiff_t place);
  void undo() override { workbench_.apply_return(session_, place_, calibrated_); }
  void redo() override;

 private:
  Workbench& workbench_;
  std::shared_ptr<const Session> session_;
  std::ptrdiff_t place_;
  Workbench::CalibratedPtr calibrated_;  ///< with the session; null where that is no part of it
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
