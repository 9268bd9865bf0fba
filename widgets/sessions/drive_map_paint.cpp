// How the map of a drive looks.
#include <QPainter>
#include <QPainterPath>
#include <cmath>

#include "widgets/basics/theme.h"
#include "widgets/charts/chart_axis.h"
#include "widgets/sessions/drive_map.h"

namespace remount::widgets {

void DriveMap::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.fillRect(rect(), palette().color(QPalette::Base));
  if (!drive_ || drive_->track_m.empty()) {
    painter.setPen(palette().color(QPalette::Disabled, QPalette::Text));
    painter.drawText(rect().adjusted(8, 8, -8, -8), Qt::AlignCenter | Qt::TextWordWrap,
                     drive_ ? tr("This drive has no INS positions.") : hint_);
    return;
  }
  painter.setRenderHint(QPainter::Antialiasing, true);
  paint_track(painter);
  paint_links(painter);
  painter.setRenderHint(QPainter::Antialiasing, false);
  paint_frame(painter);
}

void DriveMap::paint_track(QPainter& painter) const {
  QColor road = palette().color(QPalette::Text);
  road.setAlphaF(0.35F);
  painter.setPen(QPen(road, 1.5));
  painter.setBrush(Qt::NoBrush);
  std::size_t next_break = 0;
  QPolygonF line;
  for (std::size_t i = 0; i < drive_->track_m.size(); ++i) {
    if (next_break < drive_->breaks.size() && drive_->breaks[next_break] == i) {
      painter.drawPolyline(line);
      line.clear();
      ++next_break;
    }
    line << on_screen(drive_->track_m[i]);
  }
  painter.drawPolyline(line);
  painter.setPen(Qt::NoPen);
  painter.setBrush(palette().color(QPalette::Text));
  painter.drawEllipse(on_screen(drive_->track_m.front()), 4.0, 4.0);
  painter.setPen(palette().color(QPalette::Text));
  // Below it, but above the scale.
  const QPointF begin = on_screen(drive_->track_m.front());
  constexpr double kScaleHeight = 34.0;
  const double below = begin.y() + 18 > height() - kScaleHeight ? -8 : 18;
  painter.drawText(begin + QPointF(-4, below), tr("start"));
}

void DriveMap::paint_link(QPainter& painter, const Link& link) const {
  const QPointF a = on_screen(link.a_m), b = on_screen(link.b_m), mid = middle(link);
  QPainterPath arc(a);
  arc.quadTo(2.0 * mid - 0.5 * (a + b), b);  // passes through the middle
  painter.drawPath(arc);
}

void DriveMap::paint_links(QPainter& painter) const {
  if (!output_) return;
  painter.setPen(Qt::NoPen);
  painter.setBrush(faint_text_color(palette()));
  for (const motion::Keyframe& keyframe : output_->keyframes)
    if (keyframe.session == session_ && keyframe.scan < drive_->scans_m.size())
      painter.drawEllipse(on_screen(drive_->scans_m[keyframe.scan]), 1.8, 1.8);
  // Rejected ones below, so that they do not hide what counts.
  for (const motion::PairState state :
       {motion::PairState::Rejected, motion::PairState::Proposed, motion::PairState::Accepted}) {
    const QColor color = state_color(state, palette());
    for (const Link& link : links_) {
      if (output_->pairs[link.pair].state != state) continue;
      const QPointF mid = middle(link);
      if (!rect().adjusted(-200, -200, 200, 200).contains(mid.toPoint())) continue;
      painter.setPen(QPen(color, 1.2, state == motion::PairState::Rejected ? Qt::DotLine : Qt::SolidLine));
      painter.setBrush(Qt::NoBrush);
      paint_link(painter, link);
      painter.setPen(Qt::NoPen);
      painter.setBrush(color);
      painter.drawEllipse(mid, 2.6, 2.6);
    }
  }
  for (const Link& link : links_) {
    if (link.pair != selected_) continue;
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(palette().color(QPalette::Highlight), 3.0));
    paint_link(painter, link);
    painter.setBrush(palette().color(QPalette::Base));
    for (const QPointF& end : {on_screen(link.a_m), on_screen(link.b_m)}) painter.drawEllipse(end, 3.5, 3.5);
    painter.setBrush(palette().color(QPalette::Highlight));
    painter.drawEllipse(middle(link), 4.0, 4.0);
  }
}

void DriveMap::paint_frame(QPainter& painter) const {
  const QColor ink = palette().color(QPalette::Text);
  painter.setPen(QPen(ink, 2));
  const double bar_m = nice_step(110.0 / pixels_per_m_, 1) > 140.0 / pixels_per_m_
                           ? nice_step(110.0 / pixels_per_m_, 2)
                           : nice_step(110.0 / pixels_per_m_, 1);
  const int length = static_cast<int>(std::lround(bar_m * pixels_per_m_)), y = height() - 10;
  painter.drawLine(10, y, 10 + length, y);
  painter.drawLine(10, y - 4, 10, y);
  painter.drawLine(10 + length, y - 4, 10 + length, y);
  painter.drawText(QPoint(14, y - 5), bar_m >= 1000.0 ? tr("%1 km").arg(bar_m / 1000.0) : tr("%1 m").arg(bar_m));
  const QPoint foot(width() - 18, 44);
  painter.drawLine(foot, foot - QPoint(0, 24));
  painter.drawLine(foot - QPoint(0, 24), foot + QPoint(-5, -16));
  painter.drawLine(foot - QPoint(0, 24), foot + QPoint(5, -16));
  // A pose file does not say where north is.
  painter.drawText(QRect(width() - 34, 2, 32, 18), Qt::AlignCenter, drive_->north_up ? tr("N") : tr("y"));
  if (!hasFocus()) return;
  painter.setPen(QPen(palette().color(QPalette::Highlight), 1));
  painter.setBrush(Qt::NoBrush);
  painter.drawRect(rect().adjusted(0, 0, -1, -1));
}

}  // namespace remount::widgets
