#include "widgets/pairs/error_chart_panel.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>

namespace remount::widgets {

ErrorChartPanel::ErrorChartPanel(QWidget* parent)
    : QWidget(parent), chart_(new ErrorBarChart(this)), measure_(new QComboBox(this)), count_(new QLabel(this)) {
  for (const PairMeasure measure : kPairMeasures) measure_->addItem(measure_name(measure));
  measure_->setAccessibleName(tr("What the bars show"));
  count_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);  // a narrow window cuts the hint, not itself
  count_->setAccessibleName(tr("What the line would reject"));
  connect(measure_, &QComboBox::currentIndexChanged, this, [this](int index) {
    chart_->set_measure(kPairMeasures.at(index_at(index)));
    emit measure_changed(chart_->measure());
  });
  connect(chart_, &ErrorBarChart::threshold_moved, this, &ErrorChartPanel::show_count);
  connect(chart_, &ErrorBarChart::reject_requested, this,
          [this](const std::vector<motion::PairIndex>& pairs, double threshold) {
            const PairMeasure measure = chart_->measure();
            emit reject_requested(pairs, tr("%1 above %2 %3")
                                             .arg(measure_name(measure).toLower())
                                             .arg(threshold, 0, 'g', 3)
                                             .arg(measure_unit(measure)));
          });
  connect(chart_, &ErrorBarChart::take_back_requested, this, &ErrorChartPanel::take_back_requested);
  auto* row = new QHBoxLayout;
  row->addWidget(measure_);
  row->addWidget(count_, 1);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(6, 4, 6, 4);
  column->addLayout(row);
  column->addWidget(chart_, 1);
  show_count(-1, -1);
}

void ErrorChartPanel::show_count(int rejected, int of) {
  count_->setText(of < 0              ? tr("drag ◀ to reject")
                  : rejected == 0     ? tr("none of the %1 kept is above").arg(of)
                  : chart_->in_hand() ? tr("rejects %1 of %2").arg(rejected).arg(of)
                                      : tr("Return rejects %1 of %2").arg(rejected).arg(of));
}

}  // namespace remount::widgets
