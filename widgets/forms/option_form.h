// A form for one section of the settings, generated from its description.
#pragma once

#include <QWidget>
#include <map>

#include "widgets/text/option_access.h"

class QDoubleSpinBox;
class QLineEdit;

namespace remount::widgets {

/// Shows values, emits what the user wants changed; the values themselves change only by show_settings.
class OptionForm : public QWidget {
  Q_OBJECT
 public:
  OptionForm(const QString& section, const settings::Settings& settings, QWidget* parent = nullptr);
  void show_settings(const settings::Settings& settings);
  void set_angle_unit(AngleUnit unit, const settings::Settings& settings);

 signals:
  void edited(const QString& section, const QString& name, const QVariant& value);

 private:
  QWidget* make_editor(const OptionField& field);
  /// Of a text that names a file, which can be looked for.
  void offer_files(QLineEdit& line, const OptionField& field);
  void set_limits(QDoubleSpinBox& spin, const OptionField& field) const;
  QString section_;
  AngleUnit angle_unit_ = AngleUnit::Degrees;
  std::map<QString, QWidget*> editors_;
};

/// Shows an option's value in the editor made for it, without a signal.
void show_in_editor(QWidget& editor, const OptionField& field, AngleUnit unit = AngleUnit::Degrees);

/// Decimals that show `value` and steps that suit it.
int decimals_for(const OptionField& field, AngleUnit unit = AngleUnit::Degrees);

}  // namespace remount::widgets
