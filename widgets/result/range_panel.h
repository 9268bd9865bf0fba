// The search range of the six parameters; angles in degrees on screen, radians in the settings.
#pragma once

#include <QWidget>
#include <map>
#include <optional>

#include "model/settings/settings.h"
#include "widgets/text/option_access.h"

class QComboBox;
class QDoubleSpinBox;
class QLabel;

namespace remount::widgets {

class RangeBar;

class RangePanel : public QWidget {
  Q_OBJECT
 public:
  explicit RangePanel(QWidget* parent = nullptr);
  void show_settings(const settings::Settings& settings);
  void set_angle_unit(AngleUnit unit);
  void show_nominal(const std::optional<RigidTransform>& ins_from_lidar);
  void show_result(const std::optional<RigidTransform>& ins_from_lidar);

 signals:
  /// `value` in the unit of the option (m, rad).
  void edited(const QString& section, const QString& name, const QVariant& value);
  void reset_requested();
  void angle_unit_chosen(widgets::AngleUnit unit);

 private:
  RangeBar* make_bar(const QString& parameter, bool angle);
  std::map<QString, QDoubleSpinBox*> editors_;  // by option name
  std::map<QString, RangeBar*> bars_;           // by parameter
  void set_limits(QDoubleSpinBox& spin, const OptionField& field) const;
  QLabel* problem_;
  QComboBox* unit_;
  AngleUnit angle_unit_ = AngleUnit::Degrees;
  settings::Settings shown_;
};

}  // namespace remount::widgets
