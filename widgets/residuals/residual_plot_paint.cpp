// How the residuals plot looks.
#include <QEvent>
#include <QPainter>
#include <algorithm>
#include <cmath>

#include "model/method_registry/calibration_method.h"
#include "widgets/basics/rows.h"
#include "widgets/basics/theme.h"
#include "widgets/charts/chart_axis.h"
#include "widgets/residuals/residual_plot.h"

namespace remount::widgets {

using motion::PairIndex;
using motion::PairState;

namespace {

constexpr int kMark_px = 9;                // a point with its edge
constexpr double kHistogramWidth_px = 70;  // at the right edge
constexpr int kBin_px = 5;
// What is rejected lies beneath what is kept: there may be far more of it.
constexpr std::array kFromBelow{PairState::Rejected, PairState::Accepted, PairState::Proposed};

/// One shape for each state: who sees no difference of colours tells them apart.
QImage mark_of(PairState state, const QPalette& palette, double ratio) {
  const int size = static_cast<int>(std::ceil(kMark_px * ratio));
  QImage mark(size, size, QImage::Format_ARGB32_Premultiplied);
  mark.fill(Qt::transparent);
  QPainter painter(&mark);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.translate(0.5 * size, 0.5 * size);
  painter.scale(ratio, ratio);
  const QColor color = state_color(state, palette);
  if (state == PairState::Accepted) {
    painter.setPen(QPen(palette.color(QPalette::Base), 0.6));
    painter.setBrush(color);
    painter.drawEllipse(QPointF(), 2.9, 2.9);
  } else if (state == PairState::Proposed) {
    painter.setPen(QPen(color, 1.6));
    painter.drawEllipse(QPointF(), 2.8, 2.8);
  } else {
    painter.setPen(QPen(color, 1.5));
    painter.drawLine(QPointF(-2.4, -2.4), QPointF(2.4, 2.4));
    painter.drawLine(QPointF(-2.4, 2.4), QPointF(2.4, -2.4));
  }
  return mark;
}

QImage ring_of(const QColor& color, double ratio) {
  const int size = static_cast<int>(std::ceil(13.0 * ratio));
  QImage mark(size, size, QImage::Format_ARGB32_Premultiplied);
  mark.fill(Qt::transparent);
  QPainter painter(&mark);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.translate(0.5 * size, 0.5 * size);
  painter.scale(ratio, ratio);
  painter.setPen(QPen(color, 1.6));
  painter.drawEllipse(QPointF(), 5.0, 5.0);
  return mark;
}

/// Points in pixels of the screen, at most one of a kind a pixel: a hundred thousand take as long as those that can be
/// told apart.
class StampedLayer {
 public:
  StampedLayer(const QSize& size, double ratio) : image_(size, QImage::Format_ARGB32_Premultiplied), ratio_(ratio) {
    image_.fill(Qt::transparent);
    painter_.begin(&image_);
  }
  void take_stamp(const QImage& stamp) {
    stamp_ = stamp;
    taken_.assign(cell_count(image_.height(), image_.width()), false);
  }
  void stamp(const QPointF& place) {
    const int x = std::clamp(static_cast<int>(place.x() * ratio_), 0, image_.width() - 1);
    const int y = std::clamp(static_cast<int>(place.y() * ratio_), 0, image_.height() - 1);
    const std::size_t pixel = cell_at(y, x, image_.width());
    if (taken_[pixel]) return;
    taken_[pixel] = true;
    painter_.drawImage(QPoint(x - stamp_.width() / 2, y - stamp_.height() / 2), stamp_);
  }
  QImage image() {
    painter_.end();
    image_.setDevicePixelRatio(ratio_);
    return image_;
  }

 private:
  QImage image_, stamp_;
  double ratio_;
  std::vector<bool> taken_;
  QPainter painter_;
};

}  // namespace

void ResidualPlot::place_area() {
  const int line = fontMetrics().height();
  const double left = fontMetrics().horizontalAdvance(QStringLiteral("-000.00")) + 8.0;
  const double histogram = width() > 320 ? kHistogramWidth_px + 6.0 : 4.0;
  frame_.area = QRectF(left, line + 8.0, std::max(20.0, width() - left - histogram),
                       std::max(20.0, height() - 3.0 * line - 16.0));
}

QRectF ResidualPlot::histogram_area() const {
  const QRectF area = frame_.area;
  return {area.right() + 2.0, area.top(), width() - area.right() - 6.0, area.height()};
}

void ResidualPlot::resizeEvent(QResizeEvent*) {
  place_area();
  change();
}

void ResidualPlot::changeEvent(QEvent* event) {
  if (event->type() == QEvent::PaletteChange || event->type() == QEvent::FontChange) {
    place_area();
    change();
  }
  QWidget::changeEvent(event);
}

void ResidualPlot::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  if (drawn_ == 0) return paint_empty(painter);
  if (picture_.isNull() || picture_.devicePixelRatio() != devicePixelRatio()) paint_picture();
  painter.drawPixmap(0, 0, picture_);
  paint_above(painter);
  if (!hasFocus()) return;
  painter.setRenderHint(QPainter::Antialiasing, false);
  painter.setPen(QPen(palette().color(QPalette::Highlight), 1));
  painter.setBrush(Qt::NoBrush);
  painter.drawRect(rect().adjusted(0, 0, -1, -1));
}

void ResidualPlot::paint_empty(QPainter& painter) const {
  painter.fillRect(rect(), palette().color(QPalette::Base));
  painter.setPen(palette().color(QPalette::Disabled, QPalette::Text));
  painter.drawText(rect().adjusted(8, 8, -8, -8), Qt::AlignCenter | Qt::TextWordWrap,
                   !output_ ? tr("No pairs yet: each pair becomes a point here.")
                   : !method_registry::is_from_pairs(output_->method) ? tr("This method works without pairs.")
                   : count() == 0                                     ? tr("There are no pairs.")
                   : summary().unknown > 0 ? tr("Of no pair both values are known: choose others.")
                                           : tr("No pair is shown: tick a state at the left."));
}

void ResidualPlot::paint_picture() {
  picture_ = QPixmap((QSizeF(size()) * devicePixelRatio()).toSize());
  picture_.setDevicePixelRatio(devicePixelRatio());
  picture_.fill(palette().color(QPalette::Base));
  QPainter painter(&picture_);
  painter.setFont(font());
  paint_axes(painter);
  paint_points(painter);
  paint_histogram(painter);
}

QString ResidualPlot::tick_text(double across) const {
  if (circumstance_ != PairCircumstance::Session) return QString::number(across, 'g', 5);
  const int session = static_cast<int>(std::lround(across)) - 1;
  return session < 0 ? QString()
                     : fontMetrics().elidedText(session_names_.value(session, QString::number(session + 1)),
                                                Qt::ElideMiddle, 110);
}

void ResidualPlot::paint_axes(QPainter& painter) const {
  const QRectF area = frame_.area;
  const int line = fontMetrics().height();
  const QPen grid(grid_color(palette())), words(palette().color(QPalette::Text));
  for (const double value :
       nice_ticks(frame_.up.low, frame_.up.high, std::max(2, static_cast<int>(area.height() / 30)))) {
    const double y = frame_.y_of(value);
    painter.setPen(value == 0.0 ? QPen(faint_text_color(palette())) : grid);
    painter.drawLine(QPointF(area.left(), y), QPointF(area.right(), y));
    painter.setPen(words);
    painter.drawText(QRectF(0, y - 10, area.left() - 5, 20), Qt::AlignRight | Qt::AlignVCenter,
                     QString::number(value, 'g', 4));
  }
  const bool sessions = circumstance_ == PairCircumstance::Session;
  std::vector<double> ticks =
      nice_ticks(frame_.across.low, frame_.across.high, std::max(2, static_cast<int>(area.width() / 80)));
  if (sessions) std::erase_if(ticks, [](double tick) { return std::abs(tick - std::round(tick)) > 1e-6; });
  for (const double value : ticks) {
    const double x = frame_.x_of(value);
    painter.setPen(grid);
    painter.drawLine(QPointF(x, area.top()), QPointF(x, area.bottom()));
    painter.setPen(words);
    painter.drawText(QRectF(x - 60, area.bottom() + 3, 120, line), Qt::AlignHCenter, tick_text(value));
  }
  painter.setPen(words);
  painter.drawText(QRectF(4, 3, area.right(), line), Qt::AlignLeft,
                   QStringLiteral("%1 [%2]").arg(name_of(measure_), unit_of(measure_)));
  painter.drawText(QRectF(area.left(), area.bottom() + line + 5, area.width(), line), Qt::AlignHCenter,
                   sessions ? name_of(circumstance_)
                            : QStringLiteral("%1 [%2]").arg(name_of(circumstance_), unit_of(circumstance_)));
}

void ResidualPlot::paint_points(QPainter& painter) const {
  const double ratio = picture_.devicePixelRatio();
  StampedLayer layer(picture_.size(), ratio);
  for (const PairState state : kFromBelow) {
    layer.take_stamp(mark_of(state, palette(), ratio));
    for (std::size_t i = 0; i < count(); ++i)
      if (states_[i] == state)
        if (const auto place = point_of(i)) layer.stamp(*place);
  }
  layer.take_stamp(ring_of(palette().color(QPalette::Highlight), ratio));
  for (const PairIndex pair : marked_)
    if (const auto place = point_of(pair)) layer.stamp(*place);
  painter.drawImage(0, 0, layer.image());
  paint_beyond(painter);
}

/// Ticks at the edge above and below which pairs lie: they are not to be forgotten.
void ResidualPlot::paint_beyond(QPainter& painter) const {
  const QRectF area = frame_.area;
  for (const PairState state : kFromBelow)
    for (std::size_t i = 0; i < count(); ++i) {
      if (states_[i] != state || !is_drawn(i) || frame_.up.holds(up_[i]) || !frame_.across.holds(across_[i])) continue;
      const double top = up_[i] > frame_.up.high ? area.top() - 4.0 : area.bottom();
      painter.fillRect(QRectF(std::floor(frame_.x_of(across_[i])) - 1.0, top, 2.0, 4.0), state_color(state, palette()));
    }
}

/// Of the points that are seen; the states one beside the other in each bar.
void ResidualPlot::paint_histogram(QPainter& painter) const {
  const QRectF area = histogram_area();
  if (area.width() < 20.0) return;
  const int bins = std::max(4, static_cast<int>(area.height()) / kBin_px);
  std::vector<std::array<int, 3>> counts(index_at(bins));
  int most = 0;
  for (std::size_t i = 0; i < count(); ++i) {
    if (!point_of(i)) continue;
    const double share = (up_[i] - frame_.up.low) / frame_.up.length();
    std::array<int, 3>& bin = counts[index_at(std::clamp(static_cast<int>(share * bins), 0, bins - 1))];
    ++bin[index_of(states_[i])];
    most = std::max(most, bin[0] + bin[1] + bin[2]);
  }
  if (most == 0) return;
  painter.setPen(grid_color(palette()));
  painter.drawLine(area.topLeft(), area.bottomLeft());
  const double high = area.height() / bins;
  for (int bin = 0; bin < bins; ++bin) {
    double left = area.left() + 1.0;
    const double top = area.bottom() - (bin + 1) * high;
    for (const PairState state : {PairState::Accepted, PairState::Proposed, PairState::Rejected}) {
      const int here = counts[index_at(bin)][index_of(state)];
      const double wide = here * (area.width() - 1.0) / most;
      if (here > 0) painter.fillRect(QRectF(left, top + 0.5, wide, high - 1.0), state_color(state, palette()));
      left += wide;
    }
  }
  painter.setPen(faint_text_color(palette()));
  painter.drawText(QRectF(area.left(), area.bottom() + 3, area.width(), fontMetrics().height()), Qt::AlignRight,
                   tr("≤ %1 pairs").arg(most));
}

void ResidualPlot::paint_above(QPainter& painter) const {
  painter.setRenderHint(QPainter::Antialiasing);
  const auto ring = [&](std::optional<PairIndex> pair, const QColor& color, double radius) {
    const std::optional<QPointF> place = pair ? place_of(*pair) : std::nullopt;
    if (!place) return;
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(palette().color(QPalette::Base), 4.0));  // an edge that is seen on crowded points
    painter.drawEllipse(*place, radius, radius);
    painter.setPen(QPen(color, 2.0));
    painter.drawEllipse(*place, radius, radius);
  };
  ring(hovered_, palette().color(QPalette::Text), 6.0);
  ring(selected_, palette().color(QPalette::Highlight), 7.5);
  if (lasso_.size() > 1) {
    QColor inside = palette().color(QPalette::Highlight);
    inside.setAlphaF(0.15F);
    painter.setBrush(inside);
    painter.setPen(QPen(palette().color(QPalette::Highlight), 1.2));
    painter.drawPolygon(lasso_);
  }
  const std::optional<PairIndex> told = hovered_ ? hovered_ : selected_;
  if (!told) return;
  painter.setPen(palette().color(QPalette::Text));
  const int taken = fontMetrics().horizontalAdvance(name_of(measure_)) + 60;
  const QRect room(taken, 3, width() - taken - 8, fontMetrics().height());
  painter.drawText(room, Qt::AlignRight, fontMetrics().elidedText(words_of(*told), Qt::ElideRight, room.width()));
}

}  // namespace remount::widgets
