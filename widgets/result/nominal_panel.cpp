#include "widgets/result/nominal_panel.h"

#include <QDoubleSpinBox>
#include <QGridLayout>
#include <QLabel>
#include <QPushButton>
#include <QRadioButton>
#include <QSignalBlocker>

#include "algorithms/calibration/calibration_result.h"
#include "widgets/basics/axes_picture.h"
#include "widgets/basics/wheel_scrolls.h"
#include "widgets/text/parameter_text.h"
#include "widgets/text/readable.h"

namespace remount::widgets {

NominalPanel::NominalPanel(QWidget* parent)
    : QWidget(parent),
      unknown_(new QRadioButton(tr("Unknown"), this)),
      known_(new QRadioButton(tr("About here:"), this)) {
  unknown_->setToolTip(tr("The mounting is found from nothing, however the sensor is turned"));
  const QString convention =
      tr("Pose of the LiDAR in the INS frame (x forward, y left, z up); R = Rz(yaw) Ry(pitch) Rx(roll)");
  const QString with_axes = tooltip_with_axes(convention);
  known_->setToolTip(with_axes);
  unknown_->setChecked(true);
  for (QRadioButton* choice : {unknown_, known_}) keep_box_visible(*choice);
  auto* file = new QPushButton(tr("From file…"), this);
  file->setToolTip(tr("A result of an earlier calibration, or any format that can be exported"));
  auto* grid = new QGridLayout(this);
  grid->setContentsMargins(0, 0, 0, 0);
  grid->addWidget(unknown_, 0, 0, 1, 2);
  grid->addWidget(known_, 1, 0, 1, 2);
  grid->addWidget(file, 1, 2, 1, 2);
  for (const calibration::Parameter i : calibration::kParameters) {
    const bool angle = calibration::is_angle(i);
    const QString text = parameter_name(i);
    auto* spin = new QDoubleSpinBox(this);
    spin->setDecimals(3);
    spin->setRange(angle ? -360.0 : -1000.0, angle ? 360.0 : 1000.0);
    spin->setSingleStep(angle ? 1.0 : 0.1);
    spin->setSuffix(unit_suffix(i));
    spin->setKeyboardTracking(false);
    let_wheel_scroll(*spin);
    spin->setAccessibleName(tr("Nominal %1").arg(text));
    spin->setAccessibleDescription(convention);
    spin->setToolTip(with_axes);
    spin->setObjectName("nominal." + QString::fromUtf8(to_string(i)));
    spin->setEnabled(false);
    connect(spin, &QDoubleSpinBox::valueChanged, this, &NominalPanel::send);
    auto* label = new QLabel(text, this);
    label->setBuddy(spin);
    const int row = 2 + calibration::row_of(i) % 3;
    grid->addWidget(label, row, angle ? 2 : 0);
    grid->addWidget(spin, row, angle ? 3 : 1);
    values_[i] = spin;
  }
  grid->setColumnStretch(1, 1);
  grid->setColumnStretch(3, 1);
  connect(known_, &QRadioButton::toggled, this, [this](bool on) {
    for (const calibration::Parameter i : calibration::kParameters) values_[i]->setEnabled(on);
    send();
  });
  connect(file, &QPushButton::clicked, this, &NominalPanel::file_requested);
}

void NominalPanel::send() {
  if (!known_->isChecked()) {
    emit nominal_edited(std::nullopt);
    return;
  }
  calibration::PerParameter<double> typed;
  for (const calibration::Parameter i : calibration::kParameters)
    typed[i] = calibration::is_angle(i) ? degrees_to_radians(values_[i]->value()) : values_[i]->value();
  emit nominal_edited(calibration::rigid_of(typed));
}

void NominalPanel::forget_numbers() {
  for (const calibration::Parameter i : calibration::kParameters) {
    const QSignalBlocker quiet(values_[i]);
    values_[i]->setValue(0.0);
  }
}

void NominalPanel::show_nominal(const std::optional<RigidTransform>& ins_from_lidar) {
  const QSignalBlocker quiet_known(known_), quiet_unknown(unknown_);
  (ins_from_lidar ? known_ : unknown_)->setChecked(true);
  const calibration::PerParameter<double> shown =
      results::six_on_screen(ins_from_lidar.value_or(RigidTransform::Identity()));
  for (const calibration::Parameter i : calibration::kParameters) {
    const QSignalBlocker quiet(values_[i]);
    values_[i]->setEnabled(ins_from_lidar.has_value());
    if (ins_from_lidar) values_[i]->setValue(shown[i]);
  }
}

}  // namespace remount::widgets
