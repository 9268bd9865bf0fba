#include "widgets/basics/distance_legend.h"

#include <QDoubleSpinBox>
#include <QHBoxLayout>
#include <QLabel>
#include <cmath>

#include "algorithms/quality/surface_distance.h"
#include "widgets/basics/color_bar.h"
#include "widgets/basics/swatch.h"
#include "widgets/scene/distance_scale.h"
#include "widgets/scene/signed_scale.h"

namespace remount::widgets {

DistanceLegend::DistanceLegend(QWidget* parent)
    : QWidget(parent),
      limit_(new QDoubleSpinBox(this)),
      medians_(new QLabel(this)),
      from_(new QLabel(this)),
      without_sides_(new ColorBar([](double share) { return to_qt(scene::DistanceScale::at(share)); }, this)),
      with_sides_(new ColorBar([](double share) { return to_qt(scene::SignedScale::at(2.0 * share - 1.0)); }, this)) {
  limit_->setRange(scene::DistanceScale::kLeast_m, scene::DistanceScale::kMost_m);
  limit_->setDecimals(2);
  limit_->setSingleStep(0.05);
  limit_->setSuffix(tr(" m"));
  limit_->setKeyboardTracking(false);
  limit_->setAccessibleName(tr("End of the distance scale"));
  limit_->setToolTip(tr("End of the scale in m. It is the same for every pair."));
  limit_->setValue(scene::DistanceScale::kDefault_m);
  connect(limit_, &QDoubleSpinBox::valueChanged, this, &DistanceLegend::limit_edited);
  auto* others =
      new QLabel(swatch(scene::DistanceScale::kOverRange, tr("more")) + QStringLiteral("&ensp;") +
                     swatch(scene::DistanceScale::kNothingNear,
                            tr("nothing within %1 m").arg(static_cast<double>(quality::SurfaceDistance::kReach_m))),
                 this);
  others->setTextFormat(Qt::RichText);
  medians_->setToolTip(tr("Median distance of the points of scan a that have a surface of scan b within %1 m, as shown")
                           .arg(static_cast<double>(quality::SurfaceDistance::kReach_m)));
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(0, 0, 0, 0);
  row->setSpacing(4);
  row->addWidget(from_);
  row->addWidget(without_sides_, 1);
  row->addWidget(with_sides_, 1);
  row->addWidget(limit_);
  row->addWidget(others);
  row->addSpacing(8);
  row->addWidget(medians_);
  show_sides(false);
}

void DistanceLegend::show_sides(bool on) {
  from_->setText(on ? tr("Behind and before scan b: ±") : tr("Distance to scan b: 0"));
  without_sides_->setVisible(!on);
  with_sides_->setVisible(on);
}

double DistanceLegend::limit_m() const { return limit_->value(); }

void DistanceLegend::set_limit(double limit_m) { limit_->setValue(limit_m); }

void DistanceLegend::show_medians(const std::vector<float>& medians_m) {
  QStringList texts;
  for (const float median : medians_m)
    texts << (std::isnan(median) ? tr("none") : tr("%1 m").arg(static_cast<double>(median), 0, 'f', 3));
  medians_->setText(texts.isEmpty() ? tr("median …") : tr("median %1").arg(texts.join(QStringLiteral(" | "))));
}

}  // namespace remount::widgets
