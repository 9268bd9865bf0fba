#include "widgets/result/range_bar.h"

#include <QMouseEvent>
#include <QPainter>
#include <QPainterPath>
#include <algorithm>
#include <cmath>

#include "widgets/basics/theme.h"
#include "widgets/charts/chart_axis.h"

namespace remount::widgets {
namespace {
constexpr double kMargin_px = 6.0, kHandleReach_px = 7.0;
}

RangeBar::RangeBar(double low, double high, QWidget* parent)
    : QWidget(parent), least_(low), most_(high), low_(low), high_(high), from_(low), to_(high) {
  setMouseTracking(true);
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
}

void RangeBar::show_range(double from, double to) {
  from_ = from;
  to_ = to;
  if (dragged_ == End::None) {  // an axis that moves under the mouse cannot be aimed at
    low_ = std::min({least_, from, to});
    high_ = std::max({most_, from, to});
  }
  update();
}

void RangeBar::show_nominal(std::optional<double> value) {
  nominal_ = value;
  update();
}

void RangeBar::show_result(std::optional<double> value) {
  result_ = value;
  update();
}

double RangeBar::x_of(double value) const {
  const double share = std::clamp((value - low_) / (high_ - low_), 0.0, 1.0);
  return kMargin_px + share * (width() - 2.0 * kMargin_px);
}

double RangeBar::value_at(double x) const {
  const double share = std::clamp((x - kMargin_px) / std::max(1.0, width() - 2.0 * kMargin_px), 0.0, 1.0);
  // To a step that a pixel is worth, so that what is dragged is a number one would type.
  const double step = nice_step((high_ - low_) / std::max(1.0, width() - 2.0 * kMargin_px), 1);
  return std::clamp(std::round((low_ + share * (high_ - low_)) / step) * step, low_, high_);
}

RangeBar::End RangeBar::end_at(double x) const {
  const double to_from = std::abs(x - x_of(from_)), to_to = std::abs(x - x_of(to_));
  if (std::min(to_from, to_to) > kHandleReach_px) return End::None;
  if (to_from == to_to) return x < x_of(from_) ? End::From : End::To;
  return to_from < to_to ? End::From : End::To;
}

void RangeBar::paint_mark(QPainter& painter, double value, const QColor& color, bool above) const {
  const double x = x_of(value), foot = above ? 0.0 : height(), tip = above ? 7.0 : height() - 7.0;
  QPainterPath mark;
  mark.moveTo(x, tip);
  mark.lineTo(x - 4.0, foot);
  mark.lineTo(x + 4.0, foot);
  mark.closeSubpath();
  painter.fillPath(mark, color);
}

void RangeBar::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing, true);
  const double middle = 0.5 * height();
  painter.setPen(Qt::NoPen);
  painter.setBrush(grid_color(palette()));
  painter.drawRoundedRect(QRectF(kMargin_px, middle - 2.0, width() - 2.0 * kMargin_px, 4.0), 2.0, 2.0);
  const QColor color = to_ < from_ ? bad_color(palette()) : state_color(motion::PairState::Proposed, palette());
  painter.setBrush(color);
  painter.drawRoundedRect(
      QRectF(QPointF(x_of(std::min(from_, to_)), middle - 2.0), QPointF(x_of(std::max(from_, to_)), middle + 2.0)), 2.0,
      2.0);
  for (const double end : {from_, to_}) painter.drawEllipse(QPointF(x_of(end), middle), 4.5, 4.5);
  if (nominal_) paint_mark(painter, *nominal_, warning_color(palette()), true);
  if (result_) paint_mark(painter, *result_, good_color(palette()), false);
}

void RangeBar::mousePressEvent(QMouseEvent* event) {
  if (event->button() == Qt::LeftButton) dragged_ = end_at(event->position().x());
}

void RangeBar::mouseMoveEvent(QMouseEvent* event) {
  const double x = event->position().x(), value = value_at(x);
  setCursor(dragged_ != End::None || end_at(x) != End::None ? Qt::SizeHorCursor : Qt::ArrowCursor);
  if (dragged_ == End::From && value <= to_ && value != from_) emit from_dragged(value);
  if (dragged_ == End::To && value >= from_ && value != to_) emit to_dragged(value);
}

void RangeBar::mouseReleaseEvent(QMouseEvent*) {
  dragged_ = End::None;
  show_range(from_, to_);
}

}  // namespace remount::widgets
