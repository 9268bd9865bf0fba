// What the next calibration is made with, beside the sessions.
#pragma once

#include <QVariant>
#include <optional>

#include "app/gui/workbench/part.h"
#include "model/settings/settings.h"

namespace remount::gui {

/// Holds the settings and the nominal mounting. Every change of them is an edit that can be undone.
class Setup : public WorkbenchPart {
  Q_OBJECT
 public:
  using WorkbenchPart::WorkbenchPart;

  const settings::Settings& settings() const { return settings_; }
  const std::optional<RigidTransform>& nominal_ins_from_lidar() const { return nominal_ins_from_lidar_; }

  void edit_option(const QString& section, const QString& name, const QVariant& value);
  void use_clock_offset(bool with_it);  ///< an edit of solve.apply_time_offset
  void reset_range();
  void reset_settings();
  void edit_nominal(const std::optional<RigidTransform>& ins_from_lidar);

  // Steps of undo commands; not undoable by themselves.
  void apply_settings(const settings::Settings& settings, const QString& step);
  void apply_nominal(const std::optional<RigidTransform>& ins_from_lidar);

  void put(const settings::Settings& settings, const std::optional<RigidTransform>& ins_from_lidar);
  /// A nominal that came from the transforms between the frames of `from` is not one between those of `to`.
  void put_nominal_of(const drive::Session& from, const drive::Session& to);
  void announce_nominal() { emit nominal_changed(); }
  void announce();

 signals:
  void settings_changed();
  void nominal_changed();
  void settings_applied(const QString& step);  ///< the settings of an edit hold, and every panel shows them

 private:
  settings::Settings settings_;
  std::optional<RigidTransform> nominal_ins_from_lidar_;
};

}  // namespace remount::gui
