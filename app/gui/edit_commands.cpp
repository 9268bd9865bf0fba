#include "app/gui/edit_commands.h"

namespace remount {

DecisionCommand::DecisionCommand(Workbench& workbench, const QString& text, std::vector<PairDecision> before,
                                 std::vector<PairDecision> after)
    : QUndoCommand(text), workbench_(workbench), before_(std::move(before)), after_(std::move(after)) {}

SettingsCommand::SettingsCommand(Workbench& workbench, const QString& text, const QString& field, const Settings& after)
    : QUndoCommand(text), workbench_(workbench), field_(field), before_(workbench.settings()), after_(after) {}

bool SettingsCommand::mergeWith(const QUndoCommand* other) {
  const auto* next = static_cast<const SettingsCommand*>(other);
  if (field_.isEmpty() || next->field_ != field_) return false;
  after_ = next->after_;
  return true;
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
