#include "app/gui/workbench/edit_commands.h"

#include <QCoreApplication>
#include <algorithm>

#include "model/method_registry/calibration_method.h"
#include "widgets/text/model_text.h"

namespace remount::gui {

QString undone(const QString& step) {
  return QCoreApplication::translate("remount::gui::edit_commands", "undo: %1").arg(step);
}

DecisionCommand::DecisionCommand(Decisions& decisions, const QString& text, std::vector<PairDecision> before,
                                 std::vector<PairDecision> after)
    : QUndoCommand(text), decisions_(decisions), before_(std::move(before)), after_(std::move(after)) {}

bool DecisionCommand::mergeWith(const QUndoCommand* other) {
  const auto* next = static_cast<const DecisionCommand*>(other);
  const bool only_why = std::equal(after_.begin(), after_.end(), next->after_.begin(), next->after_.end(),
                                   [](const PairDecision& a, const PairDecision& b) {
                                     return a.pair == b.pair && a.state == b.state && a.decided_by == b.decided_by;
                                   });
  if (!only_why) return false;
  after_ = next->after_;
  setText(next->text());
  return true;
}

SettingsCommand::SettingsCommand(Setup& setup, const QString& text, const QString& field,
                                 const settings::Settings& after)
    : QUndoCommand(text), setup_(setup), field_(field), before_(setup.settings()), after_(after) {}

bool SettingsCommand::mergeWith(const QUndoCommand* other) {
  const auto* next = static_cast<const SettingsCommand*>(other);
  if (field_.isEmpty() || next->field_ != field_) return false;
  after_ = next->after_;
  return true;
}

CalibrationCommand::CalibrationCommand(Calibrations& calibrations, std::string method, CalibratedPtr before)
    : calibrations_(calibrations), method_(std::move(method)), before_(std::move(before)) {
  setText(CalibrationCommand::name());
}

QString CalibrationCommand::name() const {
  const method_registry::CalibrationMethod* method = method_registry::find_method(method_);
  return Calibrations::tr("calibration (%1)")
      .arg(method ? widgets::model_text(method->title()) : QString::fromStdString(method_));
}

void CalibrationCommand::undo() {
  after_ = calibrations_.calibrated();
  calibrations_.apply(before_, undone(text()));
}

void CalibrationCommand::redo() {
  if (after_) calibrations_.apply(after_, text());
}

TopicsCommand::TopicsCommand(SessionEdits& edits, Setup& setup, const Calibrations& calibrations, SessionPtr before,
                             SessionPtr after)
    : QUndoCommand(QCoreApplication::translate("remount::gui::edit_commands", "other topics of %1")
                       .arg(QString::fromStdString(before->name))),
      edits_(edits),
      setup_(setup),
      before_(std::move(before)),
      after_(std::move(after)),
      calibrated_(calibrations.calibrated()),
      nominal_before_(setup.nominal_ins_from_lidar()) {}

void TopicsCommand::undo() {
  undone_ = true;
  nominal_after_ = setup_.nominal_ins_from_lidar();  // a session that was opened since may have brought one
  edits_.apply_exchange(after_, before_, calibrated_);
  setup_.apply_nominal(nominal_before_);
}

void TopicsCommand::redo() {
  edits_.apply_exchange(before_, after_, nullptr);
  if (undone_) setup_.apply_nominal(nominal_after_);
}

OpeningCommand::OpeningCommand(SessionList& list, Setup& setup, std::vector<SessionPtr> sessions)
    : list_(list),
      setup_(setup),
      sessions_(std::move(sessions)),
      nominal_before_(setup.nominal_ins_from_lidar()),
      nominal_after_(nominal_before_) {
  for (const auto& session : sessions_)
    if (!nominal_after_) nominal_after_ = session->nominal_ins_from_lidar;
  setText(OpeningCommand::name());
}

QString OpeningCommand::name() const {
  return sessions_.size() == 1
             ? QCoreApplication::translate("remount::gui::edit_commands", "open %1")
                   .arg(QString::fromStdString(sessions_.front()->name))
             : QCoreApplication::translate("remount::gui::edit_commands", "open %1 sessions").arg(sessions_.size());
}

void OpeningCommand::undo() {
  list_.apply_closing(sessions_);
  if (!nominal_before_ && nominal_after_) setup_.apply_nominal(nominal_before_);
}

void OpeningCommand::redo() {
  list_.apply_opening(sessions_);
  if (!nominal_before_ && nominal_after_) setup_.apply_nominal(nominal_after_);
}

RemovalCommand::RemovalCommand(SessionEdits& edits, const Calibrations& calibrations, SessionPtr session,
                               motion::SessionIndex place)
    : QUndoCommand(QCoreApplication::translate("remount::gui::edit_commands", "remove %1")
                       .arg(QString::fromStdString(session->name))),
      edits_(edits),
      calibrations_(calibrations),
      session_(std::move(session)),
      place_(place) {}

void RemovalCommand::redo() {
  calibrated_ = calibrations_.is_of_output(*session_) ? calibrations_.calibrated() : nullptr;
  edits_.apply_removal(session_);
}

NominalCommand::NominalCommand(Setup& setup, const QString& text, const std::optional<RigidTransform>& after)
    : QUndoCommand(text), setup_(setup), before_(setup.nominal_ins_from_lidar()), after_(after) {}

bool NominalCommand::mergeWith(const QUndoCommand* other) {
  const auto* next = static_cast<const NominalCommand*>(other);
  if (!after_ || !next->after_) return false;  // unknown <-> known is an edit of its own
  after_ = next->after_;
  return true;
}

}  // namespace remount::gui
