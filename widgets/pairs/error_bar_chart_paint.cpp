// How the bar chart of errors looks.
#include <QPainter>
#include <QPainterPath>
#include <algorithm>
#include <cmath>

#include "model/method_registry/calibration_method.h"
#include "widgets/basics/theme.h"
#include "widgets/charts/chart_axis.h"
#include "widgets/pairs/error_bar_chart.h"

namespace remount::widgets {

void ErrorBarChart::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.fillRect(rect(), palette().color(QPalette::Base));
  const QRect area = plot_area();
  if (pairs_.empty()) {
    painter.setPen(palette().color(QPalette::Disabled, QPalette::Text));
    painter.drawText(rect().adjusted(8, 8, -8, -8), Qt::AlignCenter | Qt::TextWordWrap,
                     !output_ ? tr("No pairs yet: the error of each pair appears here.")
                     : !method_registry::is_from_pairs(output_->method) ? tr("This method works without pairs.")
                     : !output_->pairs.empty() ? tr("No pair is shown: the filter of the table hides them.")
                                               : tr("There are no pairs."));
    return;
  }
  paint_axis(painter, area);
  paint_bars(painter, area);
  paint_selection(painter, area);
  paint_threshold(painter, area);
  if (!hasFocus()) return;
  painter.setPen(QPen(palette().color(QPalette::Highlight), 1));
  painter.setBrush(Qt::NoBrush);
  painter.drawRect(rect().adjusted(0, 0, -1, -1));
}

void ErrorBarChart::paint_axis(QPainter& painter, const QRect& area) const {
  for (const double value : nice_ticks(0.0, top_, std::max(2, area.height() / 36))) {
    const int y = y_of(value);
    painter.setPen(grid_color(palette()));
    painter.drawLine(area.left(), y, area.right(), y);
    painter.setPen(palette().color(QPalette::Text));
    painter.drawText(QRect(0, y - 10, area.left() - 5, 20), Qt::AlignRight | Qt::AlignVCenter,
                     QString::number(value, 'g', 4));
  }
  painter.drawText(QRect(4, 2, area.left() + 40, area.top() - 6), Qt::AlignLeft | Qt::AlignVCenter,
                   QStringLiteral("[%1]").arg(measure_unit(measure_)));
  const QRect below(area.left(), area.bottom() + 3, area.width(), height() - area.bottom() - 4);
  painter.setPen(faint_text_color(palette()));
  painter.drawText(below, Qt::AlignLeft, tr("pair %1").arg(pairs_.front()));
  if (count() > 1) painter.drawText(below, Qt::AlignRight, tr("pair %1").arg(pairs_.back()));
}

void ErrorBarChart::paint_bars(QPainter& painter, const QRect& area) const {
  const double width = static_cast<double>(area.width()) / count();
  const double gap = width > 4.0 ? 1.0 : 0.0;
  const double line = threshold_.value_or(std::numeric_limits<double>::infinity());
  // Where several pairs share a column of pixels, the largest is drawn; those that are kept before those that are not.
  struct Column {
    double value = -1.0;
    int place = -1;
  };
  std::vector<Column> columns(index_at(std::max(1, width < 1.0 ? area.width() + 1 : count())));
  for (int place = 0; place < count(); ++place) {
    const auto column = static_cast<std::size_t>(width < 1.0 ? place * width : place);
    const double value = value_of(pairs_[index_at(place)]).value_or(-1.0);
    if (columns[column].place < 0 || value > columns[column].value) columns[column] = {value, place};
  }
  for (const Column& column : columns) {
    if (column.place < 0) continue;
    const motion::Pair& shown = pair(pairs_[index_at(column.place)]);
    const double left = area.left() + column.place * width, wide = std::max(1.0, width - gap);
    if (column.value < 0.0) {  // never aligned: a stub on the axis, no bar
      painter.fillRect(QRectF(left, area.bottom() + 1, wide, 2), grid_color(palette()));
      continue;
    }
    const double height = std::max(1.0, std::min(1.0, column.value / top_) * area.height());
    const bool goes = shown.state != motion::PairState::Rejected && column.value > line;
    painter.fillRect(QRectF(left, area.bottom() - height, wide, height),
                     goes ? bad_color(palette()) : state_color(shown.state, palette()));
    if (column.value > top_) painter.fillRect(QRectF(left, area.top() - 3, wide, 3), bad_color(palette()));
  }
}

void ErrorBarChart::paint_selection(QPainter& painter, const QRect& area) const {
  const int place = place_of(selected_);
  if (place < 0) return;
  const double width = static_cast<double>(area.width()) / count();
  const double centre = area.left() + (place + 0.5) * width;
  painter.setPen(QPen(palette().color(QPalette::Highlight), 2));
  painter.setBrush(Qt::NoBrush);
  painter.drawRect(
      QRectF(centre - std::max(2.5, 0.5 * width), area.top() - 4, std::max(5.0, width), area.height() + 6));
  painter.setPen(palette().color(QPalette::Text));
  const std::optional<double> value = value_of(*selected_);
  painter.drawText(
      QRect(area.left() + 44, 2, area.width() - 44, area.top() - 6), Qt::AlignRight | Qt::AlignVCenter,
      tr("pair %1: %2")
          .arg(*selected_)
          .arg(value ? QStringLiteral("%1 %2").arg(*value, 0, 'g', 3).arg(measure_unit(measure_)) : tr("not aligned")));
}

void ErrorBarChart::paint_threshold(QPainter& painter, const QRect& area) const {
  const QPoint grip = handle();
  const QColor color = threshold_ ? bad_color(palette()) : faint_text_color(palette());
  QPainterPath triangle;
  triangle.moveTo(area.right() + 2, grip.y());
  triangle.lineTo(area.right() + 2 + kHandleWidth, grip.y() - 6);
  triangle.lineTo(area.right() + 2 + kHandleWidth, grip.y() + 6);
  triangle.closeSubpath();
  painter.setRenderHint(QPainter::Antialiasing, true);
  painter.fillPath(triangle, color);
  painter.setRenderHint(QPainter::Antialiasing, false);
  if (!threshold_) return;
  painter.setPen(QPen(color, 2));
  painter.drawLine(area.left(), grip.y(), area.right() + 2, grip.y());
  const std::size_t above = above_threshold().size();
  const QString line = QStringLiteral("%1 %2").arg(*threshold_, 0, 'g', 3).arg(measure_unit(measure_));
  const QString text = above > 0 ? tr("rejects %1 of %2 above %3").arg(above).arg(kept_count()).arg(line)
                                 : tr("none of the %1 kept is above %2").arg(kept_count()).arg(line);
  const QFontMetrics metrics = fontMetrics();
  const int wide = metrics.horizontalAdvance(text) + 10;
  const bool beneath = grip.y() - metrics.height() - 6 < area.top();
  const QRect box(area.left() + 6, beneath ? grip.y() + 3 : grip.y() - metrics.height() - 5, wide,
                  metrics.height() + 2);
  painter.fillRect(box, tint(color, palette()));
  painter.setPen(palette().color(QPalette::Text));
  painter.drawText(box, Qt::AlignCenter, text);
}

}  // namespace remount::widgets
