#include "widgets/charts/error_bar_chart.h"

#include <QHelpEvent>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QToolTip>
#include <algorithm>
#include <cmath>

#include "widgets/theme.h"

namespace remount {
namespace {

/// 1, 2 or 5 times a power of ten, not below value / steps.
double nice_step(double value, int steps) {
  const double raw = value / steps;
  const double power = std::pow(10.0, std::floor(std::log10(raw)));
  for (double factor : {1.0, 2.0, 5.0})
    if (factor * power >= raw) return factor * power;
  return 10.0 * power;
}

}  // namespace

ErrorBarChart::ErrorBarChart(QWidget* parent) : QWidget(parent) {
  setFocusPolicy(Qt::StrongFocus);
  setAccessibleName(tr("Error of each pair"));
  setAccessibleDescription(tr("One bar per pair. Left and right arrow keys select the neighbouring pair."));
}

void ErrorBarChart::show_output(std::shared_ptr<const PipelineOutput> output) {
  output_ = std::move(output);
  update();
}

void ErrorBarChart::show_selected(int pair) {
  selected_ = pair;
  update();
}

void ErrorBarChart::set_measure(PairMeasure measure) {
  measure_ = measure;
  update();
}

int ErrorBarChart::pair_count() const { return output_ ? static_cast<int>(output_->pairs.size()) : 0; }

double ErrorBarChart::value_of(int pair) const {
  const Pair& chosen = output_->pairs.at(static_cast<std::size_t>(pair));
  double value = 0.0;
  switch (measure_) {
    case PairMeasure::ResidualTranslation:
      value = 100.0 * chosen.residual_translation_m;
      break;
    case PairMeasure::ResidualRotation:
      value = radians_to_degrees(chosen.residual_rotation_rad);
      break;
    case PairMeasure::Rmse:
      value = 100.0 * chosen.registration.rmse_m;
      break;
    case PairMeasure::Screw:
      value = chosen.screw.score;
      break;
  }
  return std::isfinite(value) ? std::max(0.0, value) : 0.0;
}

QString ErrorBarChart::unit_text() const {
  switch (measure_) {
    case PairMeasure::ResidualTranslation:
      return tr("residual translation [cm]");
    case PairMeasure::ResidualRotation:
      return tr("residual rotation [°]");
    case PairMeasure::Rmse:
      return tr("alignment RMSE [cm]");
    case PairMeasure::Screw:
      return tr("screw test [σ]");
  }
  return {};
}

QRect ErrorBarChart::plot_area() const {
  const QFontMetrics metrics = fontMetrics();
  return rect().adjusted(metrics.horizontalAdvance(QStringLiteral("000.00")) + 10, metrics.height() + 8, -8,
                         -metrics.height() - 6);
}

double ErrorBarChart::top_of_axis() const {
  // A few wild pairs must not flatten all others: the axis ends at 1.5 times the 95th percentile of the pairs that
  // are not rejected; bars beyond it are cut and marked.
  std::vector<double> values, kept;
  for (int pair = 0; pair < pair_count(); ++pair) {
    values.push_back(value_of(pair));
    if (output_->pairs[static_cast<std::size_t>(pair)].state != PairState::Rejected) kept.push_back(values.back());
  }
  if (!kept.empty()) values = std::move(kept);
  if (values.empty()) return 1.0;
  std::sort(values.begin(), values.end());
  const double high = values[static_cast<std::size_t>(0.95 * static_cast<double>(values.size() - 1))];
  const double top = high > 0.0 ? std::min(values.back(), 1.5 * high) : values.back();
  return top > 0.0 ? 1.05 * top : 1.0;
}

int ErrorBarChart::pair_at(const QPoint& position) const {
  const QRect area = plot_area();
  if (pair_count() == 0 || area.width() <= 0 || position.x() < area.left() || position.x() > area.right()) return -1;
  const double share = static_cast<double>(position.x() - area.left()) / area.width();
  return std::clamp(static_cast<int>(share * pair_count()), 0, pair_count() - 1);
}

void ErrorBarChart::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.fillRect(rect(), palette().color(QPalette::Base));
  const QRect area = plot_area();
  if (pair_count() == 0) {
    painter.setPen(palette().color(QPalette::Disabled, QPalette::Text));
    painter.drawText(rect(), Qt::AlignCenter | Qt::TextWordWrap,
                     tr("No pairs yet: the error of each pair appears here."));
    return;
  }
  const double top = top_of_axis();
  paint_axis(painter, area, top);
  paint_bars(painter, area, top);
}

void ErrorBarChart::paint_axis(QPainter& painter, const QRect& area, double top) const {
  QColor grid = palette().color(QPalette::Text);
  grid.setAlphaF(0.15F);
  const double step = nice_step(top, std::max(2, area.height() / 36));
  for (double value = 0.0; value <= top; value += step) {
    const int y = area.bottom() - static_cast<int>(value / top * area.height());
    painter.setPen(grid);
    painter.drawLine(area.left(), y, area.right(), y);
    painter.setPen(palette().color(QPalette::Text));
    painter.drawText(QRect(0, y - 10, area.left() - 5, 20), Qt::AlignRight | Qt::AlignVCenter,
                     QString::number(value, 'g', 4));
  }
  painter.drawText(QRect(4, 2, width() - 8, area.top() - 4), Qt::AlignLeft | Qt::AlignVCenter, unit_text());
  painter.drawText(QRect(area.left(), area.bottom() + 3, area.width(), height() - area.bottom() - 4), Qt::AlignLeft,
                   QStringLiteral("0"));
  painter.drawText(QRect(area.left(), area.bottom() + 3, area.width(), height() - area.bottom() - 4), Qt::AlignRight,
                   tr("pair %1").arg(pair_count() - 1));
}

void ErrorBarChart::paint_bars(QPainter& painter, const QRect& area, double top) const {
  const double width = static_cast<double>(area.width()) / pair_count();
  const auto x_of = [&](int pair) { return area.left() + pair * width; };
  const double gap = width > 4.0 ? 1.0 : 0.0;
  std::vector<double> column_height(static_cast<std::size_t>(area.width() + 1), -1.0);
  for (int pair = 0; pair < pair_count(); ++pair) {
    const double value = value_of(pair);
    if (width < 1.0) {  // several pairs share a column of pixels: the largest is drawn
      double& highest = column_height[static_cast<std::size_t>(x_of(pair) - area.left())];
      if (value <= highest) continue;
      highest = value;
    }
    const double height = std::max(1.0, std::min(1.0, value / top) * area.height());
    const QRectF bar(x_of(pair), area.bottom() - height, std::max(1.0, width - gap), height);
    const QColor color = state_color(output_->pairs[static_cast<std::size_t>(pair)].state, palette());
    painter.fillRect(bar, color);
    if (value > top) painter.fillRect(QRectF(bar.left(), area.top() - 3, bar.width(), 3), bad_color(palette()));
  }
  if (selected_ < 0 || selected_ >= pair_count()) return;
  const double centre = x_of(selected_) + 0.5 * width;
  painter.setPen(QPen(palette().color(QPalette::Highlight), 2));
  painter.setBrush(Qt::NoBrush);
  painter.drawRect(
      QRectF(centre - std::max(2.5, 0.5 * width), area.top() - 4, std::max(5.0, width), area.height() + 6));
  painter.setPen(palette().color(QPalette::Text));
  painter.drawText(QRect(area.left(), 2, area.width(), area.top() - 6), Qt::AlignRight | Qt::AlignVCenter,
                   tr("pair %1: %2").arg(selected_).arg(value_of(selected_), 0, 'g', 3));
}

void ErrorBarChart::mousePressEvent(QMouseEvent* event) {
  const int pair = pair_at(event->pos());
  if (pair >= 0) emit pair_clicked(pair);
}

void ErrorBarChart::keyPressEvent(QKeyEvent* event) {
  const int step = event->key() == Qt::Key_Left ? -1 : event->key() == Qt::Key_Right ? 1 : 0;
  if (step == 0 || pair_count() == 0) return QWidget::keyPressEvent(event);
  emit pair_clicked(std::clamp(selected_ + step, 0, pair_count() - 1));
}

bool ErrorBarChart::event(QEvent* event) {
  if (event->type() == QEvent::ToolTip) {
    auto* help = static_cast<QHelpEvent*>(event);
    const int pair = pair_at(help->pos());
    if (pair < 0) {
      QToolTip::hideText();
    } else {
      const Pair& chosen = output_->pairs[static_cast<std::size_t>(pair)];
      QString text =
          tr("pair %1: %2 %3, %4").arg(pair).arg(value_of(pair), 0, 'g', 3).arg(unit_text(), state_text(chosen));
      if (!chosen.reason.empty()) text += '\n' + QString::fromStdString(chosen.reason);
      QToolTip::showText(help->globalPos(), text, this);
    }
    return true;
  }
  return QWidget::event(event);
}

}  // namespace remount
