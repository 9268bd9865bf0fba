// The search range of the six parameters; angles in degrees on screen, radians in the settings.
#pragma once

#include <QWidget>
#include <map>

#include "model/settings.h"

class QDoubleSpinBox;
class QLabel;

namespace remount {

class RangePanel : public QWidget {
  Q_OBJECT
 public:
  explicit RangePanel(QWidget* parent = nullptr);
  void show_settings(const Settings& settings);

 signals:
  /// `value` in the unit of the option (m, rad).
  void edited(const QString& section, const QString& name, const QVariant& value);
  void reset_requested();

 private:
  std::map<QString, QDoubleSpinBox*> editors_;  // by option name
  QLabel* problem_;
};

}  // namespace remount
