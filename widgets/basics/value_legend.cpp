#include "widgets/basics/value_legend.h"

#include <QHBoxLayout>
#include <QLabel>

#include "widgets/basics/color_bar.h"
#include "widgets/basics/swatch.h"
#include "widgets/scene/distance_scale.h"

namespace remount::widgets {

ValueLegend::ValueLegend(QWidget* parent)
    : QWidget(parent),
      low_(new QLabel(this)),
      high_(new QLabel(this)),
      bar_(new ColorBar([](double share) { return to_qt(scene::DistanceScale::at(share)); }, this)) {
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(0, 0, 0, 0);
  row->setSpacing(4);
  row->addWidget(low_);
  row->addWidget(bar_, 1);
  row->addWidget(high_);
}

void ValueLegend::show_range(const QString& name, double low, double high, const QString& unit) {
  const auto text = [&](double value) { return QStringLiteral("%1 %2").arg(value, 0, 'g', 4).arg(unit).trimmed(); };
  low_->setText(tr("%1: %2").arg(name, text(low)));
  high_->setText(text(high));
  bar_->show();
}

void ValueLegend::show_message(const QString& text) {
  low_->setText(text);
  high_->clear();
  bar_->hide();
}

}  // namespace remount::widgets
