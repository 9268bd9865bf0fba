// Edits that can be undone.
#pragma once

#include <QUndoCommand>

#include "app/gui/workbench/calibrations.h"
#include "app/gui/workbench/session_edits.h"

namespace remount::gui {

/// "undo: reject pair 12".
QString undone(const QString& step);

class DecisionCommand : public QUndoCommand {
 public:
  DecisionCommand(Decisions& decisions, const QString& text, std::vector<PairDecision> before,
                  std::vector<PairDecision> after);
  void undo() override { decisions_.apply(before_, undone(text())); }
  void redo() override { decisions_.apply(after_, text()); }
  int id() const override { return 3; }
  /// Saying why right after rejecting is one edit.
  bool mergeWith(const QUndoCommand* other) override;

 private:
  Decisions& decisions_;
  std::vector<PairDecision> before_, after_;
};

/// `field` names what was edited ("range.x_min_m"): turning one knob step by step is one edit.
class SettingsCommand : public QUndoCommand {
 public:
  SettingsCommand(Setup& setup, const QString& text, const QString& field, const settings::Settings& after);
  void undo() override { setup_.apply_settings(before_, undone(text())); }
  void redo() override { setup_.apply_settings(after_, text()); }
  int id() const override { return 1; }
  bool mergeWith(const QUndoCommand* other) override;

 private:
  Setup& setup_;
  QString field_;
  settings::Settings before_, after_;
};

/// A calibration that took the place of `before`. Made when it is there already. `method`: its id.
class CalibrationCommand : public NamedEdit {
 public:
  CalibrationCommand(Calibrations& calibrations, std::string method, CalibratedPtr before);
  QString name() const override;
  void undo() override;
  void redo() override;

 private:
  Calibrations& calibrations_;
  std::string method_;
  CalibratedPtr before_, after_;  ///< after: once it was undone
};

/// Another session of the same recording takes the place of one; its result goes and comes back with it.
class TopicsCommand : public QUndoCommand {
 public:
  TopicsCommand(SessionEdits& edits, Setup& setup, const Calibrations& calibrations, SessionPtr before,
                SessionPtr after);
  void undo() override;
  void redo() override;

 private:
  SessionEdits& edits_;
  Setup& setup_;
  SessionPtr before_, after_;
  CalibratedPtr calibrated_;  ///< with `before_`
  std::optional<RigidTransform> nominal_before_, nominal_after_;
  bool undone_ = false;
};

/// Sessions are opened, and with them the nominal that they bring where there is none.
class OpeningCommand : public NamedEdit {
 public:
  OpeningCommand(SessionList& list, Setup& setup, std::vector<SessionPtr> sessions);
  QString name() const override;
  void undo() override;
  void redo() override;
  int id() const override { return History::kOpening; }

 private:
  SessionList& list_;
  Setup& setup_;
  std::vector<SessionPtr> sessions_;
  std::optional<RigidTransform> nominal_before_, nominal_after_;
};

/// A session is closed; what was calibrated from it goes and comes back with it.
class RemovalCommand : public QUndoCommand {
 public:
  RemovalCommand(SessionEdits& edits, const Calibrations& calibrations, SessionPtr session, motion::SessionIndex place);
  void undo() override { edits_.apply_return(session_, place_, calibrated_); }
  void redo() override;

 private:
  SessionEdits& edits_;
  const Calibrations& calibrations_;
  SessionPtr session_;
  motion::SessionIndex place_;
  CalibratedPtr calibrated_;  ///< with the session; null where that is no part of it
};

class NominalCommand : public QUndoCommand {
 public:
  NominalCommand(Setup& setup, const QString& text, const std::optional<RigidTransform>& after);
  void undo() override { setup_.apply_nominal(before_); }
  void redo() override { setup_.apply_nominal(after_); }
  int id() const override { return 2; }
  bool mergeWith(const QUndoCommand* other) override;

 private:
  Setup& setup_;
  std::optional<RigidTransform> before_, after_;
};

}  // namespace remount::gui
