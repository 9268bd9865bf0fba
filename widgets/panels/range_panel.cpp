#include "widgets/panels/range_panel.h"

#include <QDoubleSpinBox>
#include <QGridLayout>
#include <QLabel>
#include <QPushButton>
#include <QSignalBlocker>

#include "widgets/forms/option_access.h"
#include "widgets/theme.h"

namespace remount {
namespace {

const QString kSection = QStringLiteral("range");

bool is_angle(const OptionField& field) { return field.unit == QLatin1String("rad"); }

}  // namespace

RangePanel::RangePanel(QWidget* parent) : QWidget(parent), problem_(new QLabel(this)) {
  auto* grid = new QGridLayout(this);
  grid->setContentsMargins(0, 0, 0, 0);
  grid->addWidget(new QLabel(tr("from"), this), 0, 1);
  grid->addWidget(new QLabel(tr("to"), this), 0, 2);
  int row = 0;
  for (const OptionField& field : option_fields(Settings{})) {
    if (field.section != kSection) continue;
    const bool lower = field.name.contains(QLatin1String("_min_"));
    const QString parameter = field.name.section('_', 0, 0);
    if (lower) grid->addWidget(new QLabel(parameter, this), ++row, 0);
    auto* spin = new QDoubleSpinBox(this);
    spin->setDecimals(is_angle(field) ? 2 : 3);
    spin->setRange(on_screen(field, field.minimum), on_screen(field, field.maximum));
    spin->setSingleStep(is_angle(field) ? 5.0 : 0.5);
    spin->setSuffix(screen_suffix(field));
    spin->setKeyboardTracking(false);
    spin->setToolTip(field.help);
    spin->setObjectName("range." + field.name);
    spin->setAccessibleName(lower ? tr("Smallest %1").arg(parameter) : tr("Largest %1").arg(parameter));
    connect(spin, &QDoubleSpinBox::valueChanged, this,
            [this, field](double value) { emit edited(kSection, field.name, from_screen(field, value)); });
    grid->addWidget(spin, row, lower ? 1 : 2);
    editors_[field.name] = spin;
  }
  problem_->setWordWrap(true);
  auto* reset = new QPushButton(tr("Widest default range"), this);
  reset->setToolTip(tr("x, y, z within 5 m and every angle"));
  connect(reset, &QPushButton::clicked, this, &RangePanel::reset_requested);
  grid->addWidget(problem_, ++row, 0, 1, 3);
  grid->addWidget(reset, ++row, 1, 1, 2);
  grid->setColumnStretch(1, 1);
  grid->setColumnStretch(2, 1);
  show_settings(Settings{});
}

void RangePanel::show_settings(const Settings& settings) {
  QStringList crossed;
  double lower = 0.0;
  for (const OptionField& field : option_fields(settings)) {
    const auto editor = editors_.find(field.name);
    if (field.section != kSection || editor == editors_.end()) continue;
    const QSignalBlocker quiet(editor->second);
    editor->second->setValue(on_screen(field, field.value.toDouble()));
    if (field.name.contains(QLatin1String("_min_")))
      lower = field.value.toDouble();
    else if (field.value.toDouble() < lower)
      crossed << field.name.section('_', 0, 0);
  }
  problem_->setVisible(!crossed.isEmpty());
  problem_->setStyleSheet("color: " + bad_color(palette()).name());
  problem_->setText(
      tr("The largest %1 is below the smallest: nothing can be found there.").arg(crossed.join(QStringLiteral(", "))));
}

}  // namespace remount
