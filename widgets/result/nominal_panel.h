// Where the LiDAR is believed to sit: unknown, six numbers, or from a file.
#pragma once

#include <QWidget>
#include <array>
#include <optional>

#include "algorithms/geometry/rigid_transform.h"

class QDoubleSpinBox;
class QRadioButton;

namespace remount::widgets {

class NominalPanel : public QWidget {
  Q_OBJECT
 public:
  explicit NominalPanel(QWidget* parent = nullptr);
  /// Where it is unknown, the numbers of before stay, greyed: to be taken up again.
  void show_nominal(const std::optional<RigidTransform>& ins_from_lidar);
  void forget_numbers();  ///< they belong to another vehicle

 signals:
  void nominal_edited(const std::optional<remount::RigidTransform>& ins_from_lidar);
  void file_requested();

 private:
  void send();
  QRadioButton* unknown_;
  QRadioButton* known_;
  calibration::PerParameter<QDoubleSpinBox*> values_;  // m and degrees
};

}  // namespace remount::widgets
