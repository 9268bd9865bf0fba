#include "widgets/quality/clearance_plot.h"

#include <QKeyEvent>
#include <QPainter>
#include <QWheelEvent>
#include <algorithm>
#include <cmath>

#include "algorithms/core/index.h"
#include "widgets/basics/rows.h"
#include "widgets/basics/theme.h"
#include "widgets/charts/chart_axis.h"

namespace remount::widgets {

QColor before_color(const QPalette& palette) {
  return is_dark(palette) ? QColor(0xf2, 0x9b, 0x4b) : QColor(0xc4, 0x5f, 0x00);
}
QColor after_color(const QPalette& palette) {
  return is_dark(palette) ? QColor(0x6c, 0xb0, 0xf5) : QColor(0x1f, 0x6f, 0xc4);
}

ClearancePlot::ClearancePlot(QWidget* parent) : QWidget(parent) {
  setFocusPolicy(Qt::StrongFocus);
  setAccessibleName(tr("The scan around the vehicle, seen from above"));
  setAccessibleDescription(tr("Plus and minus zoom, Home shows what is near."));
  setToolTip(tr("Seen from above, forward is right; metres from the INS. The wheel zooms, Home shows what is near."));
}

MeasuredScan measure_scan(const VehicleScan& scan, const quality::VehicleBox& box) {
  const auto from_above = [&box](const std::vector<Eigen::Vector3f>& points_in_vehicle) {
    std::vector<Eigen::Vector2f> places_m;
    for (const Eigen::Vector3f& point : points_in_vehicle)
      if (point.allFinite() && quality::within_heights(point, box)) places_m.push_back(point.head<2>());
    return places_m;
  };
  return {box, from_above(scan.before), from_above(scan.after), quality::find_clearances(scan.before, box),
          quality::find_clearances(scan.after, box)};
}

void ClearancePlot::show_scan(const QString& name, MeasuredScanPtr scan) {
  name_ = name;
  scan_ = std::move(scan);
  const quality::VehicleBox& box = scan_->box;
  message_ = scan_->free_before.obstacles + scan_->free_after.obstacles > 0 ? QString()
             : box.height_min_m < box.height_max_m                          ? tr("No points within the heights.")
                                                   : tr("The lowest height lies above the highest: no point counts.");
  draw_points();
}

void ClearancePlot::name_before(const QString& words) {
  before_name_ = words;
  update();
}

void ClearancePlot::show_message(const QString& text) {
  scan_.reset();
  name_.clear();
  message_ = text;
  update();
}

const MeasuredScan& ClearancePlot::shown() const {
  static const MeasuredScan nothing;
  return scan_ ? *scan_ : nothing;
}

QRectF ClearancePlot::area() const {
  const double line = fontMetrics().height(), left = fontMetrics().horizontalAdvance(QStringLiteral("-00 ")) + 4.0;
  return {left, 2.0 * line + 6.0, width() - left - 4.0, height() - 3.0 * line - 10.0};
}

double ClearancePlot::pixels_per_m() const {
  // What a planner looks at: the vehicle and as much around it as is free, within limits.
  constexpr double kLeast_m = 2.5, kMost_m = 6.0;
  double around_m = kLeast_m;
  for (const quality::Clearances* found : {&shown().free_before, &shown().free_after})
    for (const quality::Clearance& side : found->sides)
      if (std::isfinite(side.distance_m)) around_m = std::max(around_m, 1.2 * side.distance_m);
  around_m = std::min(around_m, kMost_m);
  const double length_m = shown().box.front_m + shown().box.rear_m + 2.0 * around_m,
               width_m = 2.0 * (shown().box.half_width_m + around_m);
  return zoom_ * std::max(1.0, std::min(area().width() / length_m, area().height() / width_m));
}

QPointF ClearancePlot::to_screen(double x_m, double y_m) const {
  const double middle_m = 0.5 * (shown().box.front_m - shown().box.rear_m);
  return area().center() + pixels_per_m() * QPointF(x_m - middle_m, -y_m);
}

void ClearancePlot::draw_points() {
  points_ = QPixmap(size() * devicePixelRatioF());
  points_.setDevicePixelRatio(devicePixelRatioF());
  points_.fill(Qt::transparent);
  update();
  if (!scan_) return;
  QPainter painter(&points_);
  painter.setClipRect(area());
  const double scale = pixels_per_m();
  const QPointF origin = to_screen(0.0, 0.0);
  const double ratio = devicePixelRatioF();
  const int columns = points_.width(), rows = points_.height();
  const auto draw = [&](const std::vector<Eigen::Vector2f>& points_m, const QColor& color) {
    // A wall gives thousands of points on one pixel: each pixel is drawn once.
    std::vector<bool> drawn(cell_count(rows, columns), false);
    std::vector<QPointF> places;
    for (const Eigen::Vector2f& point_m : points_m) {
      const QPointF place = origin + scale * QPointF(point_m.x(), -point_m.y());
      const double column = ratio * place.x(), row = ratio * place.y();
      if (!(column >= 0.0 && column < columns && row >= 0.0 && row < rows)) continue;
      auto pixel = drawn[cell_at(row, column, columns)];
      if (!pixel) places.push_back(place);
      pixel = true;
    }
    painter.setPen(QPen(color, 1.6));
    painter.drawPoints(places.data(), qt_count(places.size()));
  };
  draw(scan_->before_m, before_color(palette()));
  draw(scan_->after_m, after_color(palette()));
}

void ClearancePlot::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.fillRect(rect(), palette().color(QPalette::Base));
  if (scan_) {
    paint_grid(painter);
    painter.drawPixmap(0, 0, points_);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setClipRect(area());
    paint_vehicle(painter);
    paint_clearances(painter, shown().free_before, before_color(palette()), -2.5);
    paint_clearances(painter, shown().free_after, after_color(palette()), 2.5);
    painter.setClipping(false);
    painter.setRenderHint(QPainter::Antialiasing, false);
  }
  painter.setPen(faint_text_color(palette()));
  painter.drawText(rect().adjusted(8, fontMetrics().height(), -8, scan_ ? -height() / 2 : -8),
                   Qt::AlignCenter | Qt::TextWordWrap, message_);
  if (!hasFocus()) return;
  painter.setPen(QPen(palette().color(QPalette::Highlight), 1));
  painter.setBrush(Qt::NoBrush);
  painter.drawRect(rect().adjusted(0, 0, -1, -1));
}

void ClearancePlot::paint_grid(QPainter& painter) const {
  const QRectF inside = area();
  const double scale = pixels_per_m(), line = fontMetrics().height();
  const QPointF origin = to_screen(0.0, 0.0);
  const double step_m = nice_step(inside.height() / scale, 5);
  const QString along = tr("x forward → [m]");
  const double numbers_end = inside.right() - fontMetrics().horizontalAdvance(along) - 8.0;
  // Zero has no sign: "-0" would stand where the first tick is rounded up to it.
  for (double x_m = std::ceil((inside.left() - origin.x()) / scale / step_m) * step_m + 0.0;
       origin.x() + scale * x_m <= inside.right(); x_m += step_m) {
    const double x = origin.x() + scale * x_m;
    painter.setPen(grid_color(palette()));
    painter.drawLine(QPointF(x, inside.top()), QPointF(x, inside.bottom()));
    painter.setPen(faint_text_color(palette()));
    const QString number = QString::number(x_m, 'g', 3);
    if (x + 0.5 * fontMetrics().horizontalAdvance(number) < numbers_end)
      painter.drawText(QRectF(x - 30, inside.bottom() + 1, 60, line), Qt::AlignCenter, number);
  }
  for (double y_m = std::ceil((origin.y() - inside.bottom()) / scale / step_m) * step_m + 0.0;
       origin.y() - scale * y_m >= inside.top(); y_m += step_m) {
    const double y = origin.y() - scale * y_m;
    painter.setPen(grid_color(palette()));
    painter.drawLine(QPointF(inside.left(), y), QPointF(inside.right(), y));
    painter.setPen(faint_text_color(palette()));
    painter.drawText(QRectF(0, y - line / 2, inside.left() - 4, line), Qt::AlignRight | Qt::AlignVCenter,
                     QString::number(y_m, 'g', 3));
  }
  painter.drawText(QRectF(inside.left(), inside.bottom() + 1, inside.width(), line), Qt::AlignRight, along);
  painter.drawText(QRectF(2, line + 3, inside.right() - 2, line), Qt::AlignLeft | Qt::TextDontClip, tr("y left ↑ [m]"));
  paint_legend(painter);
}

void ClearancePlot::paint_legend(QPainter& painter) const {
  const double line = fontMetrics().height();
  const QRectF title(4, 2, width() - 8.0, line);
  painter.setPen(before_color(palette()));
  const QString before = QStringLiteral("● ") + before_name_, after = tr("● with the result");
  painter.drawText(title, Qt::AlignLeft, before);
  painter.setPen(after_color(palette()));
  painter.drawText(title.adjusted(fontMetrics().horizontalAdvance(before) + 14, 0, 0, 0), Qt::AlignLeft, after);
  painter.setPen(faint_text_color(palette()));
  const double left = fontMetrics().horizontalAdvance(before + after) + 30.0;
  painter.drawText(title.adjusted(left, 0, 0, 0), Qt::AlignRight,
                   fontMetrics().elidedText(name_, Qt::ElideLeft, static_cast<int>(title.width() - left)));
}

void ClearancePlot::paint_vehicle(QPainter& painter) const {
  const quality::VehicleBox& box = shown().box;
  const QRectF outline(to_screen(-box.rear_m, box.half_width_m), to_screen(box.front_m, -box.half_width_m));
  painter.setPen(QPen(palette().color(QPalette::Text), 1.6));
  painter.setBrush(Qt::NoBrush);
  painter.drawRect(outline);
  // The nose, so that nobody mistakes the rear for the front.
  const double nose_px = std::min(0.35 * outline.height(), 0.25 * outline.width());
  painter.drawLine(QPointF(outline.right() - nose_px, outline.top()), QPointF(outline.right(), outline.center().y()));
  painter.drawLine(QPointF(outline.right() - nose_px, outline.bottom()),
                   QPointF(outline.right(), outline.center().y()));
  const QPointF ins = to_screen(0.0, 0.0);
  painter.drawLine(ins - QPointF(5, 0), ins + QPointF(5, 0));
  painter.drawLine(ins - QPointF(0, 5), ins + QPointF(0, 5));
}

void ClearancePlot::paint_clearances(QPainter& painter, const quality::Clearances& found, const QColor& color,
                                     double shift_px) const {
  const quality::VehicleBox& box = shown().box;
  painter.setPen(QPen(color, 1.8));
  for (std::size_t i = 0; i < found.sides.size(); ++i) {
    if (!std::isfinite(found.sides[i].distance_m)) continue;
    const Eigen::Vector3f& point = found.sides[i].point_in_vehicle;
    const bool along = i == index_of(quality::Side::Front) || i == index_of(quality::Side::Rear);
    const double edge_x_m = std::clamp<double>(point.x(), -box.rear_m, box.front_m);
    const double edge_y_m = std::clamp<double>(point.y(), -box.half_width_m, box.half_width_m);
    const QPointF beside = along ? QPointF(0.0, shift_px) : QPointF(shift_px, 0.0);  // both stay to be seen
    const QPointF from = to_screen(edge_x_m, edge_y_m) + beside, to = to_screen(point.x(), point.y()) + beside;
    painter.drawLine(from, to);
    painter.drawEllipse(to_screen(point.x(), point.y()), 4.0, 4.0);
  }
  if (!std::isfinite(found.nearest.distance_m)) return;
  const Eigen::Vector3f& nearest = found.nearest.point_in_vehicle;
  painter.drawRect(QRectF(to_screen(nearest.x(), nearest.y()) - QPointF(5, 5), QSizeF(10, 10)));
}

void ClearancePlot::zoom(double factor) {
  zoom_ = std::clamp(zoom_ * factor, 0.1, 20.0);
  draw_points();
}

void ClearancePlot::resizeEvent(QResizeEvent*) { draw_points(); }

void ClearancePlot::wheelEvent(QWheelEvent* event) { zoom(std::pow(1.0015, event->angleDelta().y())); }

void ClearancePlot::keyPressEvent(QKeyEvent* event) {
  if (event->key() == Qt::Key_Plus || event->key() == Qt::Key_Equal) return zoom(1.25);
  if (event->key() == Qt::Key_Minus) return zoom(0.8);
  if (event->key() == Qt::Key_Home) return zoom(1.0 / zoom_);
  QWidget::keyPressEvent(event);
}

void ClearancePlot::changeEvent(QEvent* event) {
  if (event->type() == QEvent::PaletteChange) draw_points();
  QWidget::changeEvent(event);
}

}  // namespace remount::widgets
