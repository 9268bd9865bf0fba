#include "widgets/result/range_panel.h"

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QGridLayout>
#include <QLabel>
#include <QPushButton>
#include <QSignalBlocker>

#include "algorithms/calibration/calibration_result.h"
#include "model/results/display_units.h"
#include "widgets/basics/axes_picture.h"
#include "widgets/basics/theme.h"
#include "widgets/basics/wheel_scrolls.h"
#include "widgets/result/range_bar.h"
#include "widgets/text/parameter_text.h"

namespace remount::widgets {
namespace {

const QString kSection = QStringLiteral("range");

/// @param parameter as files name it
QString name_of(const QString& parameter) {
  const std::optional<calibration::Parameter> known = calibration::parameter_from_string(parameter.toStdString());
  return known ? parameter_name(*known) : parameter;
}

}  // namespace

RangePanel::RangePanel(QWidget* parent) : QWidget(parent), problem_(new QLabel(this)), unit_(new QComboBox(this)) {
  auto* grid = new QGridLayout(this);
  grid->setContentsMargins(0, 0, 0, 0);
  grid->setVerticalSpacing(1);
  grid->addWidget(new QLabel(tr("from"), this), 0, 1);
  grid->addWidget(new QLabel(tr("to"), this), 0, 2);
  int row = 0;
  for (const OptionField& field : option_fields(settings::Settings{})) {
    if (field.section != kSection) continue;
    const bool lower = field.name.contains(QLatin1String("_min_"));
    const QString parameter = field.name.section('_', 0, 0), words = name_of(parameter);
    if (lower) {
      grid->addWidget(new QLabel(words, this), ++row, 0);
      grid->addWidget(make_bar(parameter, is_angle(field)), ++row, 1, 1, 2);
    }
    auto* spin = new QDoubleSpinBox(this);
    set_limits(*spin, field);
    spin->setKeyboardTracking(false);
    let_wheel_scroll(*spin);
    spin->setToolTip(tooltip_with_axes(option_help(field)));
    spin->setAccessibleDescription(option_help(field));
    spin->setObjectName("range." + field.name);
    spin->setAccessibleName(lower ? tr("Smallest %1").arg(words) : tr("Largest %1").arg(words));
    connect(spin, &QDoubleSpinBox::valueChanged, this,
            [this, field](double value) { emit edited(kSection, field.name, from_screen(field, value, angle_unit_)); });
    grid->addWidget(spin, row - 1, lower ? 1 : 2);
    editors_[field.name] = spin;
  }
  problem_->setWordWrap(true);
  auto* reset = new QPushButton(tr("Widest range"), this);
  reset->setToolTip(tr("x, y, z within 5 m and every angle"));
  connect(reset, &QPushButton::clicked, this, &RangePanel::reset_requested);
  grid->addWidget(problem_, ++row, 0, 1, 3);
  unit_->addItems({tr("degrees"), tr("radians")});
  unit_->setAccessibleName(tr("Unit of angles"));
  unit_->setToolTip(tr("In which unit angles of range and options are shown and typed"));
  connect(unit_, &QComboBox::activated, this,
          [this](int index) { emit angle_unit_chosen(static_cast<AngleUnit>(index)); });
  grid->addWidget(unit_, ++row, 1);
  grid->addWidget(reset, row, 2);
  grid->setColumnStretch(1, 1);
  grid->setColumnStretch(2, 1);
  show_settings(settings::Settings{});
}

void RangePanel::set_limits(QDoubleSpinBox& spin, const OptionField& field) const {
  const bool radians = angle_unit_ == AngleUnit::Radians;
  spin.setDecimals(!is_angle(field) ? 3 : radians ? 6 : 2);
  spin.setRange(on_screen(field, field.minimum, angle_unit_), on_screen(field, field.maximum, angle_unit_));
  spin.setSingleStep(!is_angle(field) ? 0.5 : radians ? 0.1 : 5.0);
  spin.setSuffix(screen_suffix(field, angle_unit_));
}

void RangePanel::set_angle_unit(AngleUnit unit) {
  angle_unit_ = unit;
  unit_->setCurrentIndex(static_cast<int>(unit));
  for (const OptionField& field : option_fields(shown_)) {
    if (field.section != kSection) continue;
    const QSignalBlocker quiet(editors_.at(field.name));
    set_limits(*editors_.at(field.name), field);
  }
  show_settings(settings::Settings(shown_));
}

RangeBar* RangePanel::make_bar(const QString& parameter, bool angle) {
  const calibration::SearchRange widest;
  auto* bar = angle ? new RangeBar(radians_to_degrees(widest.yaw_min_rad), radians_to_degrees(widest.yaw_max_rad), this)
                    : new RangeBar(widest.x_min_m, widest.x_max_m, this);
  bar->setAccessibleName(tr("Range of %1").arg(name_of(parameter)));
  bar->setToolTip(tr("Drag the ends. ▼ above: the nominal mounting; ▲ below: the result."));
  const QString unit = angle ? QStringLiteral("rad") : QStringLiteral("m");
  const auto edit = [this, angle](const QString& name, double value) {  // bars are in degrees
    const bool convert = angle && angle_unit_ == AngleUnit::Radians;
    editors_.at(name)->setValue(convert ? degrees_to_radians(value) : value);
  };
  connect(bar, &RangeBar::from_dragged, this,
          [edit, name = parameter + "_min_" + unit](double value) { edit(name, value); });
  connect(bar, &RangeBar::to_dragged, this,
          [edit, name = parameter + "_max_" + unit](double value) { edit(name, value); });
  bars_[parameter] = bar;
  return bar;
}

void RangePanel::show_nominal(const std::optional<RigidTransform>& ins_from_lidar) {
  for (const calibration::Parameter i : calibration::kParameters)
    bars_.at(QString::fromUtf8(to_string(i)))
        ->show_nominal(ins_from_lidar ? std::optional(results::six_on_screen(*ins_from_lidar)[i]) : std::nullopt);
}

void RangePanel::show_result(const std::optional<RigidTransform>& ins_from_lidar) {
  for (const calibration::Parameter i : calibration::kParameters)
    bars_.at(QString::fromUtf8(to_string(i)))
        ->show_result(ins_from_lidar ? std::optional(results::six_on_screen(*ins_from_lidar)[i]) : std::nullopt);
}

void RangePanel::show_settings(const settings::Settings& settings) {
  shown_ = settings;
  QStringList crossed;
  double lower = 0.0;
  for (const OptionField& field : option_fields(settings)) {
    const auto editor = editors_.find(field.name);
    if (field.section != kSection || editor == editors_.end()) continue;
    const QSignalBlocker quiet(editor->second);
    editor->second->setValue(on_screen(field, field.value.toDouble(), angle_unit_));
    const QString parameter = field.name.section('_', 0, 0);
    if (field.name.contains(QLatin1String("_min_"))) {
      lower = field.value.toDouble();
      continue;
    }
    bars_.at(parameter)->show_range(on_screen(field, lower), on_screen(field, field.value.toDouble()));
    if (field.value.toDouble() < lower) crossed << name_of(parameter);
  }
  problem_->setVisible(!crossed.isEmpty());
  set_style(*problem_, text_in(bad_color));
  problem_->setText(
      tr("The largest %1 is below the smallest: nothing can be found there.").arg(crossed.join(QStringLiteral(", "))));
}

}  // namespace remount::widgets
