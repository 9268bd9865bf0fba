#include "widgets/result/correlation_chart.h"

#include <QHelpEvent>
#include <QPainter>
#include <QToolTip>
#include <cmath>

#include "model/report/report.h"
#include "widgets/charts/chart_axis.h"
#include "widgets/text/parameter_text.h"

namespace remount::widgets {
namespace {

/// Blue for negative, orange for positive, stronger with size; apart for the colour-blind, too.
QColor correlation_color(double value, const QPalette& palette) {
  const QColor base = palette.color(QPalette::Base),
               full = value < 0.0 ? QColor(0x2b, 0x7b, 0xd6) : QColor(0xe0, 0x7b, 0x1a);
  const double share = 0.75 * std::min(1.0, std::abs(value));
  const auto mix = [share](int a, int b) { return static_cast<int>(a * share + b * (1.0 - share)); };
  return {mix(full.red(), base.red()), mix(full.green(), base.green()), mix(full.blue(), base.blue())};
}

}  // namespace

CorrelationChart::CorrelationChart(QWidget* parent) : QWidget(parent) {
  setAccessibleName(tr("Correlations of the six parameters"));
}

void CorrelationChart::show_result(const calibration::CalibrationResult& result) {
  double strongest = 0.0;
  QString words = tr("no two parameters are correlated");
  for (const calibration::Parameter i : calibration::kParameters)
    for (const calibration::Parameter k : calibration::kParameters) {
      values_[i][k] = report::correlation(result, i, k);
      if (i >= k || !(std::abs(values_[i][k]) > strongest)) continue;
      strongest = std::abs(values_[i][k]);
      words =
          tr("strongest: %1 with %2, %3").arg(parameter_name(i), parameter_name(k)).arg(rounded_text(values_[i][k], 2));
    }
  setAccessibleDescription(words);
  update();
}

QRect CorrelationChart::cell(int row, int column) const {
  const int left = fontMetrics().horizontalAdvance(QStringLiteral("pitch")) + 6, top = fontMetrics().height() + 2;
  const int wide = (width() - left) / 6, high = (height() - top) / 6;
  return {left + column * wide, top + row * high, wide - 1, high - 1};
}

void CorrelationChart::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  for (const calibration::Parameter one : calibration::kParameters) {
    const int i = calibration::row_of(one);
    const QString name = parameter_name(one);
    painter.setPen(palette().color(QPalette::WindowText));
    const QRect first = cell(0, i), side = cell(i, 0);
    painter.drawText(QRect(first.left(), 0, first.width(), first.top() - 2), Qt::AlignCenter, name);
    painter.drawText(QRect(0, side.top(), side.left() - 4, side.height()), Qt::AlignRight | Qt::AlignVCenter, name);
    for (const calibration::Parameter other : calibration::kParameters) {
      const int k = calibration::row_of(other);
      const double value = values_[one][other];
      const bool known = std::isfinite(value);
      painter.fillRect(cell(i, k),
                       known && i != k ? correlation_color(value, palette()) : palette().color(QPalette::Base));
      painter.setPen(known && i != k ? palette().color(QPalette::Text) : faint_text_color(palette()));
      painter.drawText(cell(i, k), Qt::AlignCenter,
                       !known   ? QStringLiteral("–")
                       : i == k ? QStringLiteral("1")
                                : rounded_text(value, 2));
    }
  }
}

bool CorrelationChart::event(QEvent* event) {
  if (event->type() != QEvent::ToolTip) return QWidget::event(event);
  auto* help = static_cast<QHelpEvent*>(event);
  for (const calibration::Parameter i : calibration::kParameters)
    for (const calibration::Parameter k : calibration::kParameters) {
      if (!cell(calibration::row_of(i), calibration::row_of(k)).contains(help->pos())) continue;
      const QString names = parameter_name(i) + QStringLiteral(" – ") + parameter_name(k);
      QToolTip::showText(help->globalPos(),
                         std::isfinite(values_[i][k])
                             ? tr("%1: %2. Near 1 or -1 the drive tells the two apart only together.")
                                   .arg(names)
                                   .arg(rounded_text(values_[i][k], 3))
                             : tr("%1: one of them is not observed").arg(names),
                         this);
      return true;
    }
  QToolTip::hideText();
  return true;
}

}  // namespace remount::widgets
