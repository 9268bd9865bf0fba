#include "app/gui/workbench/setup.h"

#include "app/gui/workbench/edit_commands.h"
#include "model/drive/session.h"
#include "widgets/text/option_access.h"

namespace remount::gui {

void Setup::edit_option(const QString& section, const QString& name, const QVariant& value) {
  settings::Settings changed = settings_;
  if (!widgets::set_option(changed, section, name, value)) return;
  desk_.history.push(new SettingsCommand(*this, tr("change %1").arg(widgets::option_label(changed, section, name)),
                                         section + '.' + name, changed));
}

void Setup::use_clock_offset(bool with_it) {
  // What was left out by choice comes back where it is clear; what was not clear is to be applied all the same.
  const bool left_out = settings_.solve.apply_time_offset == calibration::ClockOffsetUse::No;
  const calibration::ClockOffsetUse use = !with_it   ? calibration::ClockOffsetUse::No
                                          : left_out ? calibration::ClockOffsetUse::Auto
                                                     : calibration::ClockOffsetUse::Yes;
  edit_option(QStringLiteral("solve"), QStringLiteral("apply_time_offset"), static_cast<int>(use));
}

void Setup::reset_range() {
  settings::Settings changed = settings_;
  changed.range = calibration::SearchRange{};
  desk_.history.push(new SettingsCommand(*this, tr("reset the search range"), {}, changed));
}

void Setup::reset_settings() {
  desk_.history.push(new SettingsCommand(*this, tr("restore default options"), {}, settings::Settings{}));
}

void Setup::edit_nominal(const std::optional<RigidTransform>& ins_from_lidar) {
  desk_.history.push(new NominalCommand(*this, tr("change the nominal mounting"), ins_from_lidar));
}

void Setup::apply_settings(const settings::Settings& settings, const QString& step) {
  settings_ = settings;
  emit settings_changed();
  emit edited();
  emit settings_applied(step);
}

void Setup::apply_nominal(const std::optional<RigidTransform>& ins_from_lidar) {
  nominal_ins_from_lidar_ = ins_from_lidar;
  emit nominal_changed();
  emit state_changed();
  emit edited();
}

void Setup::put(const settings::Settings& settings, const std::optional<RigidTransform>& ins_from_lidar) {
  settings_ = settings;
  nominal_ins_from_lidar_ = ins_from_lidar;
}

void Setup::put_nominal_of(const drive::Session& from, const drive::Session& to) {
  if (nominal_ins_from_lidar_ && from.nominal_ins_from_lidar &&
      nominal_ins_from_lidar_->isApprox(*from.nominal_ins_from_lidar))
    nominal_ins_from_lidar_ = to.nominal_ins_from_lidar;
}

void Setup::announce() {
  emit settings_changed();
  emit nominal_changed();
}

}  // namespace remount::gui
