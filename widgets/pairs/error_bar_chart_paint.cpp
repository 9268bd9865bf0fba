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
  const int first = std::clamp(static_cast<int>(seen_.low), 0, count() - 1),
            last = std::clamp(static_cast<int>(std::ceil(seen_.high)) - 1, first, count() - 1);
  painter.setPen(faint_text_color(palette()));
  painter.drawText(below, Qt::AlignLeft, tr("pair %1").arg(pairs_[index_at(first)]));
  if (last > first) painter.drawText(below, Qt::AlignRight, tr("pair %1").arg(pairs_[index_at(last)]));
}

/// Where several pairs share a bar, the largest is drawn.
void ErrorBarChart::paint_bars(QPainter& painter, const QRect& area) const {
  const double line = threshold_.value_or(std::numeric_limits<double>::infinity());
  for (const Bar& bar : bars()) {
    const motion::PairIndex index = pairs_[index_at(bar.place)];
    QRectF span = span_of(bar).intersected(QRectF(area.left(), 0, area.width() + 1, this->height()));
    if (bar.value < 0.0) {  // never aligned: a stub on the axis, no bar
      painter.fillRect(QRectF(span.left(), area.bottom() + 1, span.width(), 2), grid_color(palette()));
      continue;
    }
    const double height = std::max(1.0, std::min(1.0, bar.value / top_) * area.height());
    const bool goes = !is_rejected(index) && bar.value > line;
    span.setTop(area.bottom() - height);
    span.setHeight(height);
    painter.fillRect(span, goes ? bad_color(palette()) : state_color(pair(index).state, palette()));
    if (bar.value > top_) painter.fillRect(QRectF(span.left(), area.top() - 3, span.width(), 3), bad_color(palette()));
  }
}

QString ErrorBarChart::words_of(motion::PairIndex index) const {
  const std::optional<double> value = value_of(index);
  return tr("pair %1: %2, %3")
      .arg(index)
      .arg(value ? QStringLiteral("%1 %2").arg(*value, 0, 'g', 3).arg(measure_unit(measure_)) : tr("not aligned"),
           state_text(pair(index)));
}

void ErrorBarChart::paint_selection(QPainter& painter, const QRect& area) const {
  const double width = bar_width();
  const auto frame = [&](std::optional<motion::PairIndex> index, const QColor& color, int line) {
    const int place = place_of(index);
    const double centre = x_of(place + 0.5);
    if (place < 0 || centre < area.left() || centre > area.right()) return;
    painter.setPen(QPen(color, line));
    painter.setBrush(Qt::NoBrush);
    painter.drawRect(
        QRectF(centre - std::max(2.5, 0.5 * width), area.top() - 4, std::max(5.0, width), area.height() + 6));
  };
  frame(hovered_, faint_text_color(palette()), 1);
  frame(selected_, palette().color(QPalette::Highlight), 2);
  const std::optional<motion::PairIndex> told = hovered_ ? hovered_ : selected_;
  if (place_of(told) < 0) return;
  painter.setPen(palette().color(QPalette::Text));
  const QRect room(area.left() + 44, 2, area.width() - 44, area.top() - 6);
  painter.drawText(room, Qt::AlignRight | Qt::AlignVCenter,
                   fontMetrics().elidedText(words_of(*told), Qt::ElideRight, room.width()));
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
  const QString text = above > 0 ? (dragging_ ? tr("rejects %1 of %2 above %3") : tr("%1 of %2 kept are above %3"))
                                       .arg(above)
                                       .arg(kept_count())
                                       .arg(line)
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
