// All options, section by section, generated from their descriptions.
#pragma once

#include <QDialog>
#include <vector>

#include "widgets/forms/option_form.h"

class QLabel;
class QPushButton;

namespace remount::widgets {

/// Stays open beside the window; every edit is sent at once and can be undone there.
class OptionsDialog : public QDialog {
  Q_OBJECT
 public:
  explicit OptionsDialog(const settings::Settings& settings, QWidget* parent = nullptr);
  void show_settings(const settings::Settings& settings);
  void set_angle_unit(AngleUnit unit, const settings::Settings& settings);

 signals:
  void edited(const QString& section, const QString& name, const QVariant& value);
  void defaults_requested();  ///< ask first: it sets back every option

 private:
  std::vector<OptionForm*> forms_;
  QLabel* problems_;
  QPushButton* defaults_ = nullptr;
};

}  // namespace remount::widgets
