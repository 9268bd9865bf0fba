#include "app/gui/workbench/edit_commands.h"

#include <QCoreApplication>
#include <algorithm>

#include "model/methods/calibration_method.h"
#include "widgets/text/model_text.h"

namespace remount {

QString undone(const QString& step) {
  return QCoreApplication::translate("remount::edit_commands", "undo: %1").arg(step);
}

DecisionCommand::DecisionCommand(Workbench& workbench, const QString& text, std::vector<PairDecision> before,
                                 std::vector<PairDecision> after)
    : QUndoCommand(text), workbench_(workbench), before_(std::move(before)), after_(std::move(after)) {}

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

SettingsCommand::SettingsCommand(Workbench& workbench, const QString& text, const QString& field, const Settings& after)
    : QUndoCommand(text), workbench_(workbench), field_(field), before_(workbench.settings()), after_(after) {}

bool SettingsCommand::mergeWith(const QUndoCommand* other) {
  const auto* next = static_cast<const SettingsCommand*>(other);
  if (field_.isEmpty() || next->field_ != field_) return false;
  after_ = next->after_;
  return true;
}

CalibrationCommand::CalibrationCommand(Workbench& workbench, std::string method, Workbench::CalibratedPtr before)
    : workbench_(workbench), method_(std::move(method)), before_(std::move(before)) {
  setText(CalibrationCommand::name());
}

QString CalibrationCommand::name() const {
  const auto& methods = calibration_methods();
  const auto method =
      std::find_if(methods.begin(), methods.end(), [&](const CalibrationMethod& one) { return one.id == method_; });
  return Workbench::tr("calibration (%1)")
      .arg(method == methods.end() ? QString::fromStdString(method_) : model_text(method->title));
}

void CalibrationCommand::undo() {
  after_ = workbench_.calibrated();
  workbench_.apply_calibration(before_, undone(text()));
}

void CalibrationCommand::redo() {
  if (after_) workbench_.apply_calibration(after_, text());
}

TopicsCommand::TopicsCommand(Workbench& workbench, std::shared_ptr<const Session> before,
                             std::shared_ptr<const Session> after)
    : QUndoCommand(QCoreApplication::translate("remount::edit_commands", "other topics of %1")
                       .arg(QString::fromStdString(before->name))),
      workbench_(workbench),
      before_(std::move(before)),
      after_(std::move(after)),
      calibrated_(workbench.calibrated()),
      nominal_before_(workbench.nominal_ins_from_lidar()) {}

void TopicsCommand::undo() {
  undone_ = true;
  nominal_after_ = workbench_.nominal_ins_from_lidar();  // a session that was opened since may have brought one
  workbench_.apply_session(after_, before_, calibrated_);
  workbench_.apply_nominal(nominal_before_);
}

void TopicsCommand::redo() {
  workbench_.apply_session(before_, after_, nullptr);
  if (undone_) workbench_.apply_nominal(nominal_after_);
}

OpeningCommand::OpeningCommand(Workbench& workbench, std::vector<std::shared_ptr<const Session>> sessions)
    : workbench_(workbench),
      sessions_(std::move(sessions)),
      nominal_before_(workbench.nominal_ins_from_lidar()),
      nominal_after_(nominal_before_) {
  for (const auto& session : sessions_)
    if (!nominal_after_) nominal_after_ = session->nominal_ins_from_lidar;
  setText(OpeningCommand::name());
}

QString OpeningCommand::name() const {
  return sessions_.size() == 1
             ? QCoreApplication::translate("remount::edit_commands", "open %1")
                   .arg(QString::fromStdString(sessions_.front()->name))
             : QCoreApplication::translate("remount::edit_commands", "open %1 sessions").arg(sessions_.size());
}

void OpeningCommand::undo() {
  workbench_.apply_closing(sessions_);
  if (!nominal_before_ && nominal_after_) workbench_.apply_nominal(nominal_before_);
}

void OpeningCommand::redo() {
  workbench_.apply_opening(sessions_);
  if (!nominal_before_ && nominal_after_) workbench_.apply_nominal(nominal_after_);
}

RemovalCommand::RemovalCommand(Workbench& workbench, std::shared_ptr<const Session> session, std::ptrdiff_t place)
    : QUndoCommand(QCoreApplication::translate("remount::edit_commands", "remove %1")
                       .arg(QString::fromStdString(session->name))),
      workbench_(workbench),
      session_(std::move(session)),
      place_(place) {}

void RemovalCommand::redo() {
  calibrated_ = workbench_.is_of_output(*session_) ? workbench_.calibrated() : nullptr;
  workbench_.apply_removal(session_);
}

NominalCommand::NominalCommand(Workbench& workbench, const QString& text, const std::optional<RigidTransform>& after)
    : QUndoCommand(text), workbench_(workbench), before_(workbench.nominal_ins_from_lidar()), after_(after) {}

bool NominalCommand::mergeWith(const QUndoCommand* other) {
  const auto* next = static_cast<const NominalCommand*>(other);
  if (!after_ || !next->after_) return false;  // unknown <-> known is an edit of its own
  after_ = next->after_;
  return true;
}

}  // namespace remount
